#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
# Every source says whose it is and under which licence, in its first lines.
source "$(dirname "${BASH_SOURCE[0]}")/rule.sh"

check() {
  local file
  sources_in "$1" '*.h' '*.hpp' '*.c' '*.cpp' '*.sh' '*.py' '*.js' '*.mjs' '*.cmake' '*.cmake.in' '*.glsl' '*.vert' \
    '*.frag' CMakeLists.txt |
    while IFS= read -r file; do
      head -n 4 "$1/$file" | grep -q 'SPDX-FileCopyrightText: .* the lithe authors' &&
        head -n 5 "$1/$file" | grep -q 'SPDX-License-Identifier: MIT' ||
        echo "$file: the two SPDX lines are missing from its head"
    done
}

break_no_head() {
  printf 'int x;\n' | write "$1/runtime/src/x.cpp"
  expected="runtime/src/x.cpp: the two SPDX lines"
}

break_licence_only() {
  printf '// SPDX-License-Identifier: MIT\nint x;\n' | write "$1/bake/src/x.h"
  expected="bake/src/x.h: the two SPDX lines"
}

run_rule "$@"
