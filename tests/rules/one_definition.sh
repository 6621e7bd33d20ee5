#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
# No two types share a name in one namespace (unnamed namespaces are a file's own): linked into one program, either's
# members would be taken for the other's, which no compiler says.
source "$(dirname "${BASH_SOURCE[0]}")/rule.sh"

check() {
  local root=$1
  sources_in "$root" '*.h' '*.hpp' '*.cpp' | grep -E '^(format|runtime|bake)/' | (
    cd "$root"
    xargs -r awk '
      FNR == 1 { space = ""; unnamed = 0 }
      /^namespace [a-z_:]+ \{/ { space = $2; unnamed = 0 }
      /^namespace \{/ { unnamed = 1 }
      /^}  \/\/ namespace$/ { unnamed = 0 }
      /^(struct|class|enum|enum class) ([a-z]+\([0-9]+\) )?[A-Za-z_]+/ && !/;[ ]*(\/\/.*)?$/ && !unnamed && space != "" {
        line = $0
        sub(/^(struct|enum class|class|enum) /, "", line)
        sub(/^alignas\([^)]*\) /, "", line)
        sub(/[^A-Za-z0-9_].*/, "", line)
        name = space "::" line
        if (name in first && first[name] != FILENAME) print FILENAME ":" FNR ": " name "   <- also in " first[name]
        else first[name] = FILENAME
      }'
  )
}

break_two_headers() {
  printf 'namespace lithe::bake {\nstruct Shape {\n};\n}\n' | write "$1/bake/src/one/shape.h"
  printf 'namespace lithe::bake {\nclass Shape {\n};\n}\n' | write "$1/bake/src/two/shape.h"
  expected="bake/src/two/shape.h:2: lithe::bake::Shape"
}
break_header_and_source() {
  printf 'namespace lithe::runtime {\nenum class Kind : int {\n};\n}\n' | write "$1/runtime/src/kind.h"
  printf 'namespace lithe::runtime {\nnamespace {\nstruct Own {\n};\n}  // namespace\nstruct Kind final {\n};\n}\n' |
    write "$1/runtime/src/other.cpp"
  expected="runtime/src/other.cpp:6: lithe::runtime::Kind"
}

run_rule "$@"
