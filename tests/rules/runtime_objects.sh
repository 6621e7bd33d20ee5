#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
# What an engine links: the runtime imports memory functions and at most four of libm's, keeps no state, throws nothing,
# knows no types at run time, is freestanding, stays small, and exports what its header declares: all of it, only that.
# Environment: CC, CXX.
source "$(dirname "${BASH_SOURCE[0]}")/rule.sh"

memory_functions='memcpy|memmove|memset'
math_functions='sqrtf?|floorf?|ceilf?|fabsf?|log2f?|exp2f?|ldexpf?|roundf?'
most_math_functions=4
most_bytes=$((120 * 1024))

# one_object ROOT: the whole runtime at -O2 as one relocatable object
one_object() {
  local root=$1 source objects=()
  rm -f "$scratch"/*.o
  while IFS= read -r source; do
    objects+=("$scratch/$(basename "$source").o")
    "${CXX:-c++}" -std=c++17 -O2 -DNDEBUG -ffp-contract=off -fno-exceptions -fno-rtti -fno-threadsafe-statics \
      -ffreestanding -nostdinc++ -fno-stack-protector -fvisibility=hidden -ffunction-sections -fdata-sections \
      -I"$root/format/include" -I"$root/runtime/include" -c "$root/runtime/src/$source" -o "${objects[-1]}" ||
      echo "runtime/src/$source does not compile freestanding"
  done < <(sources_in "$root/runtime/src" '*.cpp')
  [ ${#objects[@]} -gt 0 ] || { echo "runtime/src has no sources"; return; }
  ld -r "${objects[@]}" -o "$scratch/runtime.o"
}

imports() { nm --undefined-only --format=posix "$1" | cut -d ' ' -f 1 | grep -v '^_GLOBAL_OFFSET_TABLE_$' || true; }

check_imports() {
  local math
  imports "$1" | grep -vxE "$memory_functions|$math_functions" | sed 's|$| is imported: only memory functions and a few of libm are allowed|' || true
  math=$(imports "$1" | grep -xE "$math_functions" || true)
  [ "$(grep -c . <<<"$math")" -le $most_math_functions ] || echo "more than $most_math_functions libm functions are imported: $(tr '\n' ' ' <<<"$math")"
}

check_no_state() {
  objdump -h -w "$1" | awk '$2 ~ /^\.(data|bss|tdata|tbss|init_array|ctors)/ && $2 !~ /^\.data\.rel\.ro/ && $3 !~ /^0+$/ {
    print $2 " holds 0x" $3 " bytes: the runtime keeps no writable globals and runs nothing at start" }'
}

check_no_exceptions() {
  nm "$1" | grep -E '__cxa_|_ZT[ISV]|_Unwind|__gxx_personality|__dynamic_cast' |
    sed 's|$|  <- exceptions or run-time type information|' || true
}

# declared ROOT: the functions that runtime.h declares LITHE_API; exported OBJECT: those other libraries can see
declared() {
  grep -v '^ *#' "$1/runtime/include/lithe/runtime.h" | tr '\n' ' ' | grep -oE 'LITHE_API [^;(]*\(' | grep -oE '[a-z0-9_]+\($' | tr -d '(' | sort -u
}
exported() { readelf -sW "$1" | awk '$5 == "GLOBAL" && $6 == "DEFAULT" && $7 != "UND" && $8 != "" { print $8 }' | sort -u; }

check_exports() {
  [ -f "$1/runtime/include/lithe/runtime.h" ] || return 0
  comm -23 <(declared "$1") <(exported "$2") | sed 's|$| is declared in runtime.h but not defined|'
  comm -13 <(declared "$1") <(exported "$2") | sed 's|$| is exported but not declared in runtime.h|'
}

check_size() {
  local bytes
  strip --strip-unneeded -o "$scratch/stripped.o" "$1"
  bytes=$(size "$scratch/stripped.o" | awk 'NR == 2 { print $1 }')
  [ "$bytes" -le $most_bytes ] || echo "the runtime's code and constants take $bytes bytes, more than $most_bytes"
}

check() {
  one_object "$1"
  [ -f "$scratch/runtime.o" ] || return 0
  check_imports "$scratch/runtime.o"
  check_no_state "$scratch/runtime.o"
  check_no_exceptions "$scratch/runtime.o"
  check_exports "$1" "$scratch/runtime.o"
  check_size "$scratch/runtime.o"
  rm -f "$scratch/runtime.o"
}

break_import() {
  printf 'extern "C" int puts(const char*);\nextern "C" int say() { return puts("x"); }\n' | write "$1/runtime/src/x.cpp"
  expected="puts is imported"
}
break_too_much_math() {
  printf '#include <math.h>\nfloat f(float x) { return floorf(x) + log2f(x) + exp2f(x) + roundf(x) + ldexpf(x, 2); }\n' | write "$1/runtime/src/x.cpp"
  expected="more than 4 libm functions"
}
break_global() {
  printf 'int counter;\nint next() { return ++counter; }\n' | write "$1/runtime/src/x.cpp"
  expected=".bss"
}
break_static_object() {
  printf 'int seed();\nint seed() { return 4; }\nextern volatile int now;\nvolatile int now = 7;\n' | write "$1/runtime/src/x.cpp"
  expected=".data"
}
break_virtual() {
  printf 'struct A { virtual int f(); };\nint A::f() { return 1; }\n' | write "$1/runtime/src/x.cpp"
  expected="exceptions or run-time type information"
}
break_hosted() {
  printf '#include <vector>\nint size() { return (int)std::vector<int>(3).size(); }\n' | write "$1/runtime/src/x.cpp"
  expected="runtime/src/x.cpp does not compile freestanding"
}
break_size() {
  printf 'extern const unsigned char table[1 << 17] = {1};\n' | write "$1/runtime/src/x.cpp"
  expected="more than $most_bytes"
}

# a_header ROOT: one declaration, over two lines as the real ones may be
a_header() { printf '#define LITHE_API __attribute__((visibility("default")))\nextern "C" {\nLITHE_API int\nlithe_x(void);\n}\n' | write "$1/runtime/include/lithe/runtime.h"; }
break_undefined_function() {
  a_header "$1"
  printf '#include "lithe/runtime.h"\nint lithe_y() { return 1; }\n' | write "$1/runtime/src/x.cpp"
  expected="lithe_x is declared in runtime.h but not defined"
}
break_undeclared_export() {
  a_header "$1"
  printf '#include "lithe/runtime.h"\nint lithe_x(void) { return 1; }\nextern "C" LITHE_API int lithe_z() { return 1; }\n' | write "$1/runtime/src/x.cpp"
  expected="lithe_z is exported but not declared in runtime.h"
}

run_rule "$@"
