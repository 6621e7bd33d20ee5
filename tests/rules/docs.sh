#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
# What the pages promise exists: links lead to files, commands to scripts, and every `lithe COMMAND --option` to an
# option that the tool's own help lists; and the figures that the README quotes stand in docs/measurements.md or docs/quality.md.
# Environment: LITHE = the built tool; without it only files are checked.
source "$(dirname "${BASH_SOURCE[0]}")/rule.sh"

pages() { sources_in "$1" '*.md'; }

check_links() {
  local page=$2 target
  { grep -oE '\]\([^)#: ]+(#[^)]*)?\)' "$1/$page" || true; } | sed -E 's/^\]\(//; s/(#.*)?\)$//' | while IFS= read -r target; do
    [ -e "$1/$(dirname "$page")/$target" ] || echo "$page: links to $target, which does not exist"
  done
}

# The lines of the page's shell blocks, comments and prompts removed, continued lines joined.
commands_of() { awk '/^ *```/ { inside = !inside && /```(sh|bash|console)/; next } inside' "$1" | sed -e ':a' -e '/\\$/N; s/\\\n//; ta' -e 's/^\$ //; s/ #.*//'; }

check_scripts() {
  local page=$2 word
  { commands_of "$1/$page" | grep -oE '(^|[ &;|])(\./)?(tests|samples|scripts)/[A-Za-z0-9_/.-]+' || true; } | tr -d ' &;|' | while IFS= read -r word; do
    [ -e "$1/$word" ] || echo "$page: $word does not exist"
  done
}

check_tool_line() {
  local page=$1 line=$2 command option help
  command=$(sed -nE 's/.*(^|[ \/])lithe ([a-z]+).*/\2/p' <<<"$line")
  help=$("$LITHE" "$command" --help 2>&1) || { echo "$page: the tool has no command '$command'"; return; }
  for option in $(grep -oE '(^| )--?[a-z][a-z0-9-]*' <<<"${line#*lithe "$command"}" || true); do
    grep -qE -- "(^|[[ ,(])$option([], =)]|\$)" <<<"$help" || echo "$page: lithe $command has no option $option"
  done
}

check_tool() {
  local page=$2 line
  [ -n "${LITHE:-}" ] || return 0
  { commands_of "$1/$page" | grep -E '(^|[ /])lithe [a-z]+ ' || true; } | while IFS= read -r line; do check_tool_line "$page" "$line"; done
}

# The figures below the README's heading Measured, those of one digit aside.
check_figures() {
  local figure
  [ -f "$1/README.md" ] || return 0
  { awk '/^#/ { inside = /^## Measured/; next } inside' "$1/README.md" | grep -oE '[0-9][0-9,.]*[0-9]' || true; } | sort -u |
    while IFS= read -r figure; do
      grep -qsF -- "$figure" "$1/docs/measurements.md" "$1/docs/quality.md" ||
        echo "README.md: the figure $figure is in neither docs/measurements.md nor docs/quality.md"
    done
}

check() {
  local page
  check_figures "$1"
  pages "$1" | while IFS= read -r page; do
    check_links "$1" "$page"
    check_scripts "$1" "$page"
    check_tool "$1" "$page"
  done
}

break_link() {
  echo 'See [the format](docs/format.md#pages).' | write "$1/README.md"
  expected="README.md: links to docs/format.md"
}
break_figure() {
  printf '12.34 and 5\n' | write "$1/docs/measurements.md"
  printf '12.36\n' | write "$1/docs/quality.md"
  printf '# x\n## Measured\n12.34 s, 12.35 s, 12.36 s\n## Else\n77\n' | write "$1/README.md"
  [[ $(check "$1") != *12.36* ]] || { echo "a figure that docs/quality.md has is not found: $(check "$1")"; return 1; }
  expected="README.md: the figure 12.35 is in neither docs/measurements.md nor docs/quality.md"
}
break_script() {
  printf '```sh\ncd x && tests/rnu.sh # all\n```\n' | write "$1/README.md"
  expected="README.md: tests/rnu.sh does not exist"
}
break_command() {
  LITHE=$scratch/lithe
  printf '#!/bin/sh\n[ "$1" = bake ] || exit 2\necho "  -o,--output TEXT  file"\n' | write "$LITHE"
  chmod +x "$LITHE"
  printf '```sh\nbuild/lithe cook a.glb\n```\n' | write "$1/docs/x.md"
  expected="docs/x.md: the tool has no command 'cook'"
}
break_option() {
  break_command "$1"
  printf '```sh\nlithe bake a.glb -o b.lithe && lithe bake a.glb --output b.lithe\n```\n' | write "$1/docs/x.md"
  [ -z "$(check "$1")" ] || { echo "options that the help lists are not found: $(check "$1")"; return 1; }
  printf '```sh\nlithe bake a.glb -o b.lithe \\\n  --quick\n```\n' | write "$1/docs/x.md"
  expected="docs/x.md: lithe bake has no option --quick"
}

run_rule "$@"
