#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
# Every public header compiles alone: runtime.h as C99 and C++17, format and runtime as C++17, bake as C++20.
# Environment: CC, CXX; LITHE_BAKE=1 to check the bake's headers too (they need its libraries).
source "$(dirname "${BASH_SOURCE[0]}")/rule.sh"

warnings=(-Wall -Wextra -Wshadow -Wpedantic -Werror)

# compile_alone WHAT HEADER COMMAND...: the header included twice (guards work) and nothing else
compile_alone() {
  local what=$1 header=$2 source log
  source=$(mktemp "$scratch/alone.XXXXXX")
  log=$source.log
  shift 2
  printf '#include "%s"\n#include "%s"\n' "$header" "$header" >"$source"
  "$@" -fsyntax-only - <"$source" 2>"$log" || echo "$header does not compile alone as $what: $(grep -m 1 error "$log")"
}

headers_in() { if [ -d "$1/$2" ]; then sources_in "$1/$2" "${@:3}"; fi; }

check() {
  local root=$1 header cxx17 c99 cxx20
  local roots=(-I"$root/format/include" -I"$root/runtime/include")
  c99=("${CC:-cc}" -std=c99 -x c "${warnings[@]}" "${roots[@]}")
  cxx17=("${CXX:-c++}" -std=c++17 -x c++ "${warnings[@]}" "${roots[@]}")
  cxx20=("${CXX:-c++}" -std=c++20 -x c++ -Wall -Wextra -Werror -I"$root/format/include" -I"$root/bake/include")
  for header in $(headers_in "$root" runtime/include '*.h'); do compile_alone C99 "$header" "${c99[@]}"; done
  for header in $(headers_in "$root" format/include '*.h') $(headers_in "$root" runtime/include '*.h' '*.hpp'); do
    compile_alone C++17 "$header" "${cxx17[@]}"
  done
  if [ "${LITHE_BAKE:-0}" = 1 ]; then
    for header in $(headers_in "$root" bake/include '*.h'); do compile_alone C++20 "$header" "${cxx20[@]}"; done
  fi
}

break_runtime_is_not_c() {
  printf '#pragma once\nnamespace lithe { int x(); }\n' | write "$1/runtime/include/lithe/runtime.h"
  expected="lithe/runtime.h does not compile alone as C99"
}
break_format_needs_another_header() {
  printf '#pragma once\ninline uint32_t x() { return 0; }\n' | write "$1/format/include/lithe/format/x.h"
  expected="lithe/format/x.h does not compile alone as C++17"
}
break_no_guard() {
  printf 'struct X { int x; };\n' | write "$1/format/include/lithe/format/x.h"
  expected="redefinition of"
}
break_bake_needs_another_header() {
  LITHE_BAKE=1
  printf '#pragma once\nstd::string x();\n' | write "$1/bake/include/lithe/bake/x.h"
  expected="lithe/bake/x.h does not compile alone as C++20"
}

run_rule "$@"
