#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
# Bad usage: exit code 2 and one sentence that leads to the help; help and version: exit code 0, on stdout.
source "$(dirname "${BASH_SOURCE[0]}")/tool.sh"

answers 0 "lithe 0." --version
answers 0 "Exit codes: 0 done, 1 bad input or failed check" --help
for command in bake info export compare verify generate; do
  answers 0 "Usage: lithe $command" "$command" --help
  answers 2 "see lithe $command --help" "$command"
done
answers 2 "--no-such-option" bake a -o b --no-such-option
answers 2 "--no-such-option" info a --no-such-option
answers 2 "--no-such-option" export a -o b --level 0 --no-such-option
answers 2 "--no-such-option" compare a b --no-such-option
answers 2 "--no-such-option" verify a --no-such-option
answers 2 "--no-such-option" generate column -o b --no-such-option
answers 2 "extra" info a extra

answers 2 "see lithe --help"
answers 2 "there is no command 'cook' (see lithe --help)" cook hero.glb
answers 2 "--output is required" bake hero.glb
answers 2 "--max-influences" bake hero.glb -o hero.lithe --max-influences 9
answers 2 "--max-influences" bake hero.glb -o hero.lithe --max-influences none
answers 2 "--metric" bake hero.glb -o hero.lithe --metric best
answers 2 "--position-bits" bake hero.glb -o hero.lithe --position-bits 40
answers 2 "--attributes" bake hero.glb -o hero.lithe --attributes normal,smell
answers 2 "dragon" generate dragon -o dragon.glb
answers 2 "Exactly 1" export hero.lithe -o hero.glb
answers 2 "Exactly 1" export hero.lithe -o hero.glb --level 1 --ratio 0.5
answers 2 "--ratio" export hero.lithe -o hero.glb --ratio 1.5
answers 2 "--phase" compare a.glb b.glb --phase late
answers 2 "--samples" compare a.glb b.glb --samples 0
holds_only . out err
finish
