#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
# What each command is for, on the column.
source "$(dirname "${BASH_SOURCE[0]}")/tool.sh"

near() { awk -v a="$1" -v b="$2" -v share="$3" 'BEGIN { exit !((a > b ? a - b : b - a) <= share * b) }'; }
at_most() { awk -v a="$1" -v b="$2" 'BEGIN { exit !(a <= b) }'; }

# info: the text and the JSON say the same.
answers 0 "114,688 triangles" info "$characters/column.lithe"
answers 0 '"levels"' info "$characters/column.lithe" --json
cp out info.json
levels=$(awk '/"levels"/ { inside = 1 } inside && /"triangles"/ { ++n } /"pages": \[/ { inside = 0 } END { print n }' info.json)
[ "$levels" -ge 3 ] || complain "the column has only $levels levels"
last=$((levels - 1))
[ "$(json info.json "levels[$last].triangles")" = 114688 ] || complain "the finest level is not the original"
[ "$(json info.json bytes)" = "$(stat -c %s "$characters/column.lithe")" ] || complain "info states another file size"
[ "$(json info.json "levels[$last].bytes")" = "$(json info.json bytes)" ] || complain "the finest level does not need the whole file"

# bake: its report says what info says.
cp "$characters/bake.json" bake.json
[ "$(json bake.json bytes)" = "$(json info.json bytes)" ] || complain "bake reports another file size than info"
[ "$(json bake.json kinds.skin)" = "$(json info.json kinds.skin)" ] || complain "bake reports other kinds of bytes than info"
[ "$(json bake.json "levels[0].triangles")" = "$(json info.json "levels[0].triangles")" ] || complain "bake reports other levels than info"

# info --bytes: what each kind takes adds up to the file, in groups and in kinds; the rest of the report stays.
answers 0 "bits/GPU vertex" info "$characters/column.lithe" --bytes
grep -q '^file ' out || complain "info --bytes prints no sum"
answers 0 '"bits_per_vertex"' info "$characters/column.lithe" --bytes --json
cp out bytes.json
# bytes_at DEPTH: the sum of all "bytes" of costs that are indented by DEPTH blanks
bytes_at() { awk -v depth="$1" '/^  "costs"/ { inside = 1 } inside && match($0, /^ */) && RLENGTH == depth && /"bytes"/ { sum += $2 } END { print sum }' bytes.json; }
[ "$(bytes_at 8)" = "$(json info.json bytes)" ] || complain "the groups add up to $(bytes_at 8) bytes"
[ "$(bytes_at 12)" = "$(json info.json bytes)" ] || complain "the kinds add up to $(bytes_at 12) bytes"
[ "$(json bytes.json costs.file.bytes)" = "$(json info.json bytes)" ] || complain "info --bytes states another file size"
[ "$(json bytes.json kinds.skin)" = "$(json info.json kinds.skin)" ] || complain "info --bytes changes the kinds"
[ "$(json bytes.json costs.groups.tangents.bytes)" = 0 ] || complain "tangents take bytes where there are none"

# verify, alone and against the original.
answers 0 "all checks passed" verify "$characters/column.lithe"
answers 0 '"levels"' verify "$characters/column.lithe" --json
# The bake has seen the clip examples alone: what it states holds in the other one.
answers 0 "beyond" verify "$characters/column.lithe" --against "$characters/column.glb" --anim test --frames 2

# export: any triangle count within a percent, any ratio, any level, all levels.
for triangles in 3000 10000 77777; do
  answers 0 "triangles" export "$characters/column.lithe" -o t.glb --triangles $triangles --json
  near "$(json out "meshes[0].triangles")" $triangles 0.01 || complain "asked for $triangles triangles, got $(json out "meshes[0].triangles")"
done
answers 0 "triangles" export "$characters/column.lithe" -o r.glb --ratio 0.1 --json
near "$(json out "meshes[0].triangles")" 11469 0.01 || complain "--ratio 0.1 gave $(json out "meshes[0].triangles")"
answers 0 "triangles" export "$characters/column.lithe" -o l.gltf --level 0 --json
[ "$(json out "meshes[0].triangles")" = "$(json info.json "levels[0].triangles")" ] || complain "--level 0 is not level 0"
answers 0 "triangles" export "$characters/column.lithe" -o all.glb --all-levels --json
[ "$(json out "meshes[0].triangles")" = 114688 ] || complain "--all-levels does not begin with the finest"
holds_only . out err json.cmake info.json bytes.json bake.json t.glb r.glb l.gltf l.bin all.glb

# Between two levels that are far apart the splits that matter most come first; in the file's own order it is 4.6e-4.
answers 0 "" bake "$characters/small.glb" -o far.lithe --levels 0.01 --quiet
answers 0 "300 triangles" export far.lithe -o far.glb --triangles 300 --from "$characters/small.glb"
answers 0 "rms" compare "$characters/small.glb" far.glb --anim test --frames 3 --json -
at_most "$(json out rms_mean)" 3.5e-4 || complain "300 triangles between levels of 2,000 and 20 are $(json out rms_mean) away"

# compare: nothing differs from itself; the small one is close; a bound that it misses is a failed check.
answers 0 "rms" compare "$characters/small.glb" "$characters/small.glb" --frames 2 --samples 500 --json -
at_most "$(json out rms_mean)" 1e-9 || complain "a character differs from itself by $(json out rms_mean)"
answers 0 "rms" compare "$characters/column.glb" "$characters/small.glb" --anim test --frames 3 --samples 2000 --json -
at_most "$(json out rms_mean)" 2e-4 || complain "2,000 triangles are $(json out rms_mean) away"
at_most 1e-6 "$(json out rms_mean)" || complain "2,000 triangles cannot be as good as the original"
answers 1 "above the allowed 1e-07" compare "$characters/column.glb" "$characters/small.glb" --anim test --frames 1 --samples 500 --quiet --fail-above-rms 1e-7

# Four triangles may end in none, from which nothing can be measured.
cat >tiny.gltf <<'END'
{"asset": {"version": "2.0"}, "nodes": [{"mesh": 0}],
 "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
 "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
               {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"}],
 "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 24}],
 "buffers": [{"byteLength": 72, "uri": "data:;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/AAACAAEAAAABAAMAAAADAAIAAQACAAMA"}]}
END
answers 0 "4 triangles" bake tiny.gltf -o tiny.lithe
if grep -q inf out; then complain "bake reports infinite bits per triangle"; fi
answers 0 "all checks passed" verify tiny.lithe --against tiny.gltf
answers 0 '"measured"' verify tiny.lithe --against tiny.gltf --json

# The same input and options give the same bytes, on any number of threads.
answers 0 "" bake "$characters/small.glb" -o one.lithe --threads 1 --quiet
answers 0 "" bake "$characters/small.glb" -o three.lithe --threads 3 --quiet
cmp one.lithe three.lithe || complain "the bytes depend on the number of threads"
if [ -s out ] || [ -s err ]; then complain "--quiet is not quiet"; fi
finish
