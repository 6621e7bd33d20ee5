#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
# lithe can be taken in all three ways: installed and found with find_package, and as a subfolder of another project;
# both from C and from C++, without the bake's libraries. Environment: CC, CXX.
source "$(dirname "${BASH_SOURCE[0]}")/rule.sh"

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
compilers=(-G Ninja -DCMAKE_C_COMPILER="${CC:-cc}" -DCMAKE_CXX_COMPILER="${CXX:-c++}")

# quietly WHAT COMMAND...: complains with the command's last lines when it fails
quietly() {
  local what=$1
  shift
  "$@" >"$scratch/log" 2>&1 || { echo "$what failed: $(grep -m 3 -iE 'error|not found|no such' "$scratch/log" | tr '\n' ' ')"; return 1; }
}

install_to() {
  quietly "configuring the runtime alone" cmake "${compilers[@]}" -S "$1" -B "$scratch/build" -DLITHE_BUILD_BAKE=OFF \
    -DLITHE_BUILD_SAMPLES=OFF -DLITHE_BUILD_TESTS=OFF -DCMAKE_BUILD_TYPE=Release &&
    quietly "building the runtime alone" cmake --build "$scratch/build" &&
    quietly "installing" cmake --install "$scratch/build" --prefix "$2"
}

# use WAY ARGUMENTS...: builds and runs the consumer
use() {
  local way=$1 program
  shift
  rm -rf "$scratch/use"
  quietly "$way: configuring a consumer" cmake "${compilers[@]}" -S "$here/consumer" -B "$scratch/use" "$@" || return 0
  quietly "$way: building a consumer" cmake --build "$scratch/use" || return 0
  for program in hello_c hello_cpp; do
    quietly "$way: running $program" "$scratch/use/$program" || continue
    grep -q 'LITHE_ERROR_NOT_THIS_FORMAT' "$scratch/log" || echo "$way: $program did not say what it should"
  done
}

check() {
  if [ -f "$1/CMakeLists.txt" ]; then
    rm -rf "$scratch/prefix" "$scratch/build"
    install_to "$1" "$scratch/prefix" || return 0
    use find_package -DCMAKE_PREFIX_PATH="$scratch/prefix"
    use add_subdirectory -DLITHE_FOLDER="$1"
  else
    use find_package -DCMAKE_PREFIX_PATH="$1"
  fi
}

break_installed_header() {
  install_to "$real_root" "$1" || return 1
  rm "$1/include/lithe/runtime.h"
  expected="find_package: building a consumer failed"
}
break_package_file() {
  install_to "$real_root" "$1" || return 1
  rm "$(find "$1" -name lithe-config.cmake)"
  expected="find_package: configuring a consumer failed"
}

run_rule "$@"
