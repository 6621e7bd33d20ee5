#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
# Runs a script of the second reader, which is written from docs/format.md alone. Skipped where there is no Python 3.
#     python_reader.sh SCRIPT ARGUMENTS...      e.g. python_reader.sh compare_runtime.py FILE.lithe 0 DUMP_BUFFERS
set -euo pipefail
command -v python3 >/dev/null || { echo "SKIPPED: python3 is not installed"; exit 77; }
exec python3 -B "$(dirname "${BASH_SOURCE[0]}")/python_reader/$1" "${@:2}"
