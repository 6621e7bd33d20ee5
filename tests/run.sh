#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
# Builds lithe and runs the whole test suite; what is missing on a Debian 12 machine is installed first.
#
#     tests/run.sh [CTEST ARGUMENTS...]      e.g. tests/run.sh -R octahedral
#
# Environment: LITHE_BUILD_DIR     build folder (default build/test)
#              LITHE_CMAKE_ARGS    further arguments for the configure step, separated by blanks
#              LITHE_JOBS          parallel jobs (default: the number of cores)
# The last lines on stdout are ctest's; the exit code is 0 when all tests passed.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/packages.sh
source scripts/stages.sh

build=${LITHE_BUILD_DIR:-build/test}
jobs=${LITHE_JOBS:-$(nproc)}
read -r -a cmake_args <<<"${LITHE_CMAKE_ARGS:-}"

stage "install what is missing" lithe_need build display
stage "configure $build" cmake -G Ninja -S . -B "$build" "${cmake_args[@]}"
stage "build" cmake --build "$build" -j "$jobs"
printf '\n== test\n'
exec ctest --test-dir "$build" -j "$jobs" --output-on-failure --no-tests=error "$@"
