# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
# The shared characters and what they are called; sourced by what measures them, which sets `models`.

shared_characters() {
  [ -d "$models" ] || return 0
  find "$models" \( -name '*.glb' -o -name '*.gltf' \) -not -path '*/assetgen/*' | LC_ALL=C sort
}

# Many exporters call every file scene.gltf: then its folder has the telling name.
name_of() {
  local name
  name=$(basename "${1%.*}")
  if [ "$name" = scene ]; then name=$(basename "$(dirname "$1")"); fi
  echo "$name"
}
