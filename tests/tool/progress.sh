#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
# What takes more than a second says on a terminal how long it will still take, and nowhere else.
source "$(dirname "${BASH_SOURCE[0]}")/tool.sh"
bake=(bake "$characters/column.glb" -o column.lithe --poses 32 --threads 1)

# on_a_terminal ARGUMENTS...: runs the tool with a terminal for stdout and stderr; what it says is left in the file said
on_a_terminal() { script -qefc "$(printf '%q ' "$lithe" "$@")" said </dev/null >/dev/null; }

on_a_terminal "${bake[@]}" || complain "the bake fails on a terminal"
grep -qE 'simplify +\[[#.]+\] +[0-9]+ %  [0-9]+ s left' said || complain "no estimate on a terminal: $(head -c 300 said)"
on_a_terminal "${bake[@]}" --quiet || complain "the quiet bake fails on a terminal"
if grep -q 'left' said; then complain "--quiet shows progress"; fi
"$lithe" "${bake[@]}" >out 2>err || complain "the bake fails"
if grep -q 'left' out err; then complain "progress without a terminal"; fi
finish
