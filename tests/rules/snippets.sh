#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
# The code on the pages is real: the README's C program is samples/01_hello/hello.c, letter for letter; the C pieces of a
# page, one after the other, are one C99 file that compiles, its C++ pieces one C++17 file; and docs/integrate.md names
# every function of runtime.h. Environment: CC, CXX.
source "$(dirname "${BASH_SOURCE[0]}")/rule.sh"

# blocks_of FILE LANGUAGE: what stands between ```LANGUAGE and ```, all of it in one go
blocks_of() { awk -v fence="\`\`\`$2" '/^```/ { inside = !inside && $0 == fence; next } inside' "$1"; }

check_hello() {
  [ -f "$1/README.md" ] || return 0
  diff <(blocks_of "$1/README.md" c) "$1/samples/01_hello/hello.c" >"$scratch/diff" ||
    echo "README.md: its C program is not samples/01_hello/hello.c: $(sed -n 2p "$scratch/diff")"
  [ "$(wc -l <"$1/samples/01_hello/hello.c")" -le 80 ] || echo "samples/01_hello/hello.c: more than 80 lines"
}

# compile_blocks ROOT PAGE LANGUAGE COMMAND...: nothing to do where the page has no such piece
compile_blocks() {
  local root=$1 page=$2 language=$3 code=$scratch/code
  shift 3
  blocks_of "$root/$page" "$language" >"$code"
  [ -s "$code" ] || return 0
  "$@" -Wall -Wextra -Werror -I"$real_root/format/include" -I"$real_root/runtime/include" -fsyntax-only - <"$code" 2>"$scratch/log" ||
    echo "$page: its $language pieces do not compile: $(grep -m 1 error "$scratch/log")"
}

check_pages() {
  local page
  sources_in "$1" '*.md' | while IFS= read -r page; do
    compile_blocks "$1" "$page" c "${CC:-cc}" -std=c99 -x c
    compile_blocks "$1" "$page" cpp "${CXX:-c++}" -std=c++17 -x c++
  done
}

check_functions() {
  local header=$1/runtime/include/lithe/runtime.h page=$1/docs/integrate.md name
  if [ ! -f "$header" ] || [ ! -f "$page" ]; then return 0; fi
  grep -v '^ *#' "$header" | tr '\n' ' ' | grep -oE 'LITHE_API [^;(]*\(' | grep -oE '[a-z0-9_]+\($' | tr -d '(' | sort -u |
    while IFS= read -r name; do
      grep -qw -- "$name" "$page" || echo "docs/integrate.md: $name of runtime.h is not mentioned"
    done
}

check() {
  check_hello "$1"
  check_pages "$1"
  check_functions "$1"
}

break_hello() {
  echo 'int main(void) { return 0; }' | write "$1/samples/01_hello/hello.c"
  printf '# x\n```c\nint main(void) { return 1; }\n```\n' | write "$1/README.md"
  expected="README.md: its C program is not samples/01_hello/hello.c"
}
break_length() {
  yes '/* */' | head -n 81 | write "$1/samples/01_hello/hello.c"
  { printf '# x\n```c\n'; yes '/* */' | head -n 81; printf '```\n'; } | write "$1/README.md"
  expected="samples/01_hello/hello.c: more than 80 lines"
}
break_c() {
  printf '```c\n#include <lithe/runtime.h>\n```\ntext\n```c\nuint32_t f(void) { return lithe_verison(); }\n```\n' | write "$1/docs/x.md"
  expected="docs/x.md: its c pieces do not compile"
}
break_cpp() {
  printf '```cpp\n#include <lithe/runtime.hpp>\nint f(lithe::Asset& a) { return a.levels(); }\n```\n' | write "$1/docs/x.md"
  expected="docs/x.md: its cpp pieces do not compile"
}
break_function() {
  printf '#define LITHE_API\nLITHE_API int\nlithe_x(void);\nLITHE_API int lithe_x_y(void);\n' | write "$1/runtime/include/lithe/runtime.h"
  echo 'lithe_x_y' | write "$1/docs/integrate.md"
  expected="docs/integrate.md: lithe_x of runtime.h is not mentioned"
}

run_rule "$@"
