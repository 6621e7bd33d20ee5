#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
# No file names a folder of somebody's machine or the host of a package registry: such a line works in one place only.
source "$(dirname "${BASH_SOURCE[0]}")/rule.sh"

# Letters in brackets keep this file from matching itself.
folders='(^|[^A-Za-z0-9_.$}~-])/([h]ome|[r]oot|[w]ork|[U]sers|[m]nt)/'
drives='[^A-Za-z][C-D]:\\\\?(Users|src)'
registries='registry\.[n]pmjs|[n]pmjs\.org|[d]eb\.debian|[p]ypi\.org|[p]ythonhosted|[p]roxy\.golang|[c]rates\.io|"[r]esolved": *"'

check() {
  (
    cd "$1"
    grep -rInE --exclude-dir=.git --exclude-dir='build*' --exclude-dir=node_modules --exclude-dir=demo \
      "$folders|$drives|$registries" . | sed 's|^\./||; s|$|   <- names one machine or registry|' || true
  )
}

break_home() {
  echo "set(DATA /ho""me/somebody/data)" | write "$1/CMakeLists.txt"
  expected="CMakeLists.txt:1:"
}
break_registry() {
  echo "\"res""olved\": \"https://regis""try.npm""js.org/x.tgz\"" | write "$1/tests/bench/package-lock.json"
  expected="package-lock.json:1:"
}

run_rule "$@"
