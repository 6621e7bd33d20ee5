#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
# Who may include whom: format <- runtime, format <- bake; the tool, samples and tests see both.
source "$(dirname "${BASH_SOURCE[0]}")/rule.sh"

# includes_of ROOT FOLDER: "file: <header>" lines of every source below the folder
includes_of() {
  [ -d "$1/$2" ] || return 0
  sources_in "$1/$2" '*.h' '*.hpp' '*.c' '*.cpp' | while IFS= read -r file; do
    sed -n 's/^ *# *include *\(["<][^">]*[">]\).*/\1/p' "$1/$2/$file" | sed "s|^|$2/$file: |"
  done
}

# only ROOT FOLDER ALLOWED MESSAGE: complains about includes that the expression does not match
only() { includes_of "$1" "$2" | grep -vE ": ($3)\$" | sed "s|\$| $4|" || true; }

# never ROOT FOLDER FORBIDDEN MESSAGE
never() { includes_of "$1" "$2" | grep -E ": ($3)" | sed "s|\$| $4|" || true; }

check() {
  local c_headers='<(stddef|stdint|string|assert|limits|float)\.h>' private='"[a-z0-9_]+\.h"'
  only "$1" format "$c_headers|\"lithe/format/[a-z0-9_]+\.h\"" "is not for format: C's freestanding headers and itself only"
  only "$1" runtime/src "$c_headers|<math\.h>|\"lithe/(format/[a-z0-9_]+|runtime)\.h\"|$private" \
    "is not for the runtime: C's headers, lithe/format and lithe/runtime.h only"
  only "$1" runtime/include "<.*>|\"lithe/(format/[a-z0-9_]+\.h|runtime\.h)\"" "is not for the runtime's headers"
  never "$1" bake/include '"lithe/runtime' "must not show in the bake's headers: bake and runtime never include each other"
  local stage
  for stage in "$1"/bake/src/*/; do
    case $(basename "$stage") in
      # They check what was written with the real reader.
      tool | pipeline) ;;
      *) never "$1" "bake/src/$(basename "$stage")" '"lithe/runtime' \
        "is the reader's: bake and runtime never include each other" ;;
    esac
  done
  # Libraries and a sample's own files are its business; of lithe it sees what a user sees.
  includes_of "$1" samples | grep ': "lithe/' | grep -vE '"lithe/(runtime\.hp?p?|bake/[a-z0-9_]+\.h)"$' |
    sed 's|$| is not for samples: they use what a user would|' || true
  local folder
  for folder in format runtime bake; do never "$1" "$folder" '"\.\./' "climbs out of its folder"; done
}

break_format_uses_stl() {
  echo '#include <vector>' | write "$1/format/include/lithe/format/x.h"
  expected="format/include/lithe/format/x.h: <vector> is not for format"
}
break_runtime_uses_bake() {
  echo '#include "lithe/bake/model.h"' | write "$1/runtime/src/x.cpp"
  expected='runtime/src/x.cpp: "lithe/bake/model.h" is not for the runtime'
}
break_runtime_uses_iostream() {
  echo '#include <iostream>' | write "$1/runtime/src/x.cpp"
  expected='<iostream> is not for the runtime'
}
break_bake_header_uses_runtime() {
  echo '#include "lithe/runtime.h"' | write "$1/bake/include/lithe/bake/x.h"
  expected="must not show in the bake's headers"
}
break_bake_stage_uses_runtime() {
  echo '# include "lithe/runtime.hpp"' | write "$1/bake/src/encode/x.cpp"
  expected="is the reader's"
}
break_sample_uses_internals() {
  echo '#include "lithe/format/page.h"' | write "$1/samples/01_hello/x.c"
  expected="is not for samples"
}
break_climbs() {
  echo '#include "../weld/grid.h"' | write "$1/bake/src/simplify/x.cpp"
  expected="climbs out of its folder"
}

run_rule "$@"
