#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
# Bad files: exit code 1, one sentence that names the file; and nothing is left behind, whole or in part.
source "$(dirname "${BASH_SOURCE[0]}")/tool.sh"

# Inputs that are not there.
answers 1 "missing.glb: " bake missing.glb -o out.lithe
answers 1 "missing.lithe: cannot be read" info missing.lithe
answers 1 "missing.lithe: cannot be read" verify missing.lithe
answers 1 "missing.lithe: cannot be read" export missing.lithe -o out.glb --level 0
answers 1 "missing.glb: " compare missing.glb "$characters/small.glb"
answers 1 ".: cannot be read: it is a folder" info .
answers 1 "missing.glb: " verify "$characters/column.lithe" --against missing.glb
answers 1 "missing.json: " bake "$characters/small.glb" -o out.lithe --pose-file missing.json

# Inputs that are something else, cut short, or damaged.
echo "this is no glTF" >text.glb
answers 1 "text.glb: " bake text.glb -o out.lithe
answers 1 "text.glb: is not a .lithe file" info text.glb
head -c 3000 "$characters/small.glb" >short.glb
answers 1 "short.glb: " bake short.glb -o out.lithe
: >empty.lithe
answers 1 "empty.lithe: ends before" info empty.lithe
head -c 200 "$characters/column.lithe" >short.lithe
answers 1 "short.lithe: ends before" verify short.lithe
head -c -1 "$characters/column.lithe" >shorter.lithe
answers 1 "shorter.lithe: " verify shorter.lithe
{ cat "$characters/column.lithe" && echo more; } >longer.lithe
answers 1 "longer.lithe: " verify longer.lithe
cp "$characters/column.lithe" flipped.lithe
size=$(stat -c %s flipped.lithe)
byte=$(od -An -tu1 -j $((size / 2)) -N 1 flipped.lithe)
printf '%b' "\\x$(printf %02x $((byte ^ 255)))" | dd of=flipped.lithe bs=1 seek=$((size / 2)) conv=notrunc status=none
answers 1 "flipped.lithe: is damaged (page " verify flipped.lithe
answers 1 "flipped.lithe: is damaged (page " export flipped.lithe -o out.glb --triangles 5000

# A number that is none: the sentence names the file, the place and what to do. A triangle without area is no fault.
triangle() { # triangle BASE64: a .gltf of one triangle, nine floats
  cat <<END
{"asset": {"version": "2.0"}, "nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
 "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
 "bufferViews": [{"buffer": 0, "byteLength": 36}], "buffers": [{"byteLength": 36, "uri": "data:;base64,$1"}]}
END
}
triangle AAAAAAAAAAAAAAAAAADAfwAAAAAAAAAAAAAAAAAAgD8AAAAA >nan.gltf
answers 1 "nan.gltf: mesh 0, primitive 0, POSITION: a value of vertex 1 is not a finite number; re-export the file" bake nan.gltf -o out.lithe
triangle AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA >flat.gltf
answers 0 "" bake flat.gltf -o flat.lithe --quiet
answers 0 "1" export flat.lithe -o flat.glb --triangles 1
triangle AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAQAAAAAAAAAAA >thin.gltf
answers 0 "" bake thin.gltf -o thin.lithe --quiet
answers 0 "all checks passed" verify thin.lithe
sed 's/"mesh": 0}]/"mesh": 0, "scale": [0, 0, 0]}]/' flat.gltf >point.gltf
answers 1 "point.gltf: every pose shrinks it to a point" bake point.gltf -o out.lithe
sed 's/"mesh": 0}]/"mesh": 0, "translation": [1e300, 0, 0]}]/' flat.gltf >far.gltf
answers 1 "far.gltf: vertices are farther than 1e15 units away" bake far.gltf -o out.lithe
rm nan.gltf flat.* thin.* point.gltf far.gltf

# Things that the file does not have.
answers 1 "has no level 99" export "$characters/column.lithe" -o out.glb --level 99
answers 1 "small.glb: " bake "$characters/small.glb" -o out.lithe --clips dance
answers 1 "dance" bake "$characters/small.glb" -o out.lithe --clips dance
answers 1 "dance" compare "$characters/small.glb" "$characters/small.glb" --anim dance

# Outputs that cannot be.
mkdir folder
answers 1 "folder: cannot be written: it is a folder" bake "$characters/small.glb" -o folder
answers 1 "nowhere/out.lithe: cannot be written: the folder nowhere does not exist" bake "$characters/small.glb" -o nowhere/out.lithe
answers 1 "nowhere/out.glb: cannot be written" generate column -o nowhere/out.glb
answers 1 "nowhere/out.glb: cannot be written" export "$characters/column.lithe" -o nowhere/out.glb --level 0
answers 1 "nowhere/r.json: cannot be written" compare "$characters/small.glb" "$characters/small.glb" --json nowhere/r.json
answers 1 "nowhere/r.json: cannot be written" bake "$characters/small.glb" -o out.lithe --json nowhere/r.json
if [ "$(id -u)" != 0 ]; then
  mkdir closed && chmod a-w closed
  answers 1 "closed/out.lithe: cannot be written: Permission denied" bake "$characters/small.glb" -o closed/out.lithe
  rmdir closed
fi
# A disk that fills up while writing: files may not grow beyond 4 KiB here.
# shellcheck disable=SC2030,SC2031
when_full() { (trap '' XFSZ && ulimit -f 4 && failures=0 && "$@" && finish) || complain "with a full disk"; }
when_full answers 1 "out.lithe: cannot be written: File too large" bake "$characters/small.glb" -o out.lithe
when_full answers 1 "out.glb: " export "$characters/column.lithe" -o out.glb --level 0
echo before >out.bin && cp out.bin out.gltf
when_full answers 1 "out.bin: " export "$characters/column.lithe" -o out.gltf --level 0
[ "$(cat out.bin out.gltf)" = "$(printf 'before\nbefore')" ] || complain "a failed export changed one of its files"
rm out.bin out.gltf
when_full answers 1 "out.glb: " generate column -o out.glb
holds_only folder ""
holds_only . folder out err text.glb short.glb empty.lithe short.lithe shorter.lithe longer.lithe flipped.lithe

# A failure leaves what was there before.
echo before >kept.lithe
answers 1 "text.glb: " bake text.glb -o kept.lithe
[ "$(cat kept.lithe)" = before ] || complain "a failed bake changed its output"
finish
