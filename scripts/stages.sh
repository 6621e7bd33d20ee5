# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
# shellcheck shell=bash
# Named, timed stages for scripts. Source this file, then: stage "what it does" COMMAND ARGUMENTS...
# The first stage that fails ends the script when `set -e` is on; call stage outside of any condition.

lithe_stage_times=()

stage() {
  local name=$1 start=$SECONDS
  shift
  printf '\n== %s\n' "$name"
  "$@"
  lithe_stage_times+=("$(printf '%5d s  %s' $((SECONDS - start)) "$name")")
  printf '== %s: done in %d s\n' "$name" $((SECONDS - start))
}

stage_summary() {
  printf '\n'
  printf '%s\n' "${lithe_stage_times[@]}"
  printf '%5d s  in all\n' "$SECONDS"
}
