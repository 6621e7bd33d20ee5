#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
# Every option does what its help says: what it changes shows in the report, in the file, or in the bytes.
source "$(dirname "${BASH_SOURCE[0]}")/tool.sh"
small=$characters/small.glb

# bakes NAME ARGUMENTS...: bakes the small character to NAME.lithe, with its report in NAME.json, and verifies it
bakes() {
  local name=$1
  shift
  answers 0 "" bake "$small" -o "$name.lithe" --json "$name.json" --quiet "$@"
  answers 0 "all checks passed" verify "$name.lithe"
}
# is FILE EXPRESSION VALUE
is() { [ "$(json "$1" "$2")" = "$3" ] || complain "$1: $2 is $(json "$1" "$2") instead of $3"; }
# orders LOW HIGH WHAT: the first number is smaller than the second
orders() { awk -v a="$1" -v b="$2" 'BEGIN { exit !(a < b) }' || complain "$3: $1 is not below $2"; }
differ() { if cmp -s "$1.lithe" "$2.lithe"; then complain "$1 and $2 have the same bytes"; fi; }

# ---- bake: what is looked at ---------------------------------------------------------------------------------------
bakes plain --poses 4
is plain.json poses 4
is plain.json weight_bits 9
for metric in rest dsd pose-independent dod; do
  bakes "$metric" --poses 4 --metric $metric
  differ plain $metric
done
bakes articulated --poses 4 --metric articulated
differ dsd dod
cmp plain.lithe articulated.lithe || complain "articulated is not the default metric"
bakes as_collapsed --poses 4 --no-refit
differ plain as_collapsed
bakes dsd_as_collapsed --poses 4 --metric dsd --no-refit
cmp dsd.lithe dsd_as_collapsed.lithe || complain "--no-refit changes a metric that never refits"
bakes clips --poses 4 --clips test
differ plain clips
bakes both --poses 4 --clips examples,test
cmp plain.lithe both.lithe || complain "all clips by name are not all clips"
answers 0 "" bake -o order.lithe --quiet --clips test --poses 4 "$small"
cmp clips.lithe order.lithe || complain "the input behind --clips was taken for a clip"
echo '{"poses": [{"nodes": {}}, {"nodes": {}}, {"nodes": {}}]}' >three.json
bakes three --poses 16 --pose-file three.json
is three.json poses 3

# ---- bake: what is kept --------------------------------------------------------------------------------------------
bakes one --poses 4 --max-influences 1
answers 0 '"max_influences": 1' info one.lithe --json
answers 0 "at most 4" info plain.lithe
bakes bare --poses 4 --attributes normal
answers 0 "weights (at most 4), normal" info bare.lithe
answers 0 '"uv_sets": 0' info bare.lithe --json
answers 0 "" info bare.lithe --bytes --json
[ "$(json out costs.groups.uvs.bytes)" = 0 ] || complain "uvs take $(json out costs.groups.uvs.bytes) bytes in a file that has none"
orders 0 "$(json out costs.groups.normals.bytes)" "the bytes of the normals that are kept"
bakes uvs --poses 4 --attributes normal,uv0
cmp plain.lithe uvs.lithe || complain "the default attributes are not those the character has"
bakes levels --poses 4 --levels 0.5,0.2
is levels.json "levels[0].triangles" 400
is levels.json "levels[1].triangles" 1000
is levels.json "levels[2].triangles" 2000

# ---- bake: how precisely -------------------------------------------------------------------------------------------
bakes positions --poses 4 --position-bits 16
orders "$(json plain.json bytes)" "$(json positions.json bytes)" "--position-bits 16 costs bytes"
bakes normals --poses 4 --normal-bits 5
orders "$(json normals.json bytes)" "$(json plain.json bytes)" "--normal-bits 5 saves bytes"
bakes uv_bits --poses 4 --uv-bits 6
orders "$(json uv_bits.json kinds.uvs)" "$(json plain.json kinds.uvs)" "--uv-bits 6 saves bytes"
bakes precise --poses 4 --precision 31
orders "$(json plain.json bytes)" "$(json precise.json bytes)" "--precision 31 costs bytes"
for bits in auto 0; do
  bakes weights --poses 4 --weight-bits $bits
  cmp plain.lithe weights.lithe || complain "--weight-bits $bits is not the default"
done
bakes weights --poses 4 --weight-bits 4
is weights.json weight_bits 4
answers 0 "weights of 4 bits" bake "$small" -o weights.lithe --weight-bits 4 --poses 4
for bits in 3 17 "" -1 many; do answers 2 "--weight-bits" bake "$small" -o no.lithe "--weight-bits=$bits"; done
answers 0 "auto chooses the 8 to 12 bits" bake --help
bakes threads --poses 4 --threads 1
cmp plain.lithe threads.lithe || complain "the bytes depend on the number of threads"
answers 0 '"weight_bits": 9' bake "$small" -o stdout.lithe --poses 4 --json -

# ---- verify, export, generate --------------------------------------------------------------------------------------
# What is stated holds in other poses when the bake has seen the default number of them.
answers 0 "" bake "$small" -o default.lithe --quiet
answers 0 "measured rms" verify default.lithe --against "$small"
answers 0 '"measured"' verify default.lithe --against "$small" --json --anim test --frames 1
cp out one_frame.json
answers 0 "" verify default.lithe --against "$small" --json --anim sampled --frames 1
if cmp -s one_frame.json out; then complain "verify --anim changes nothing"; fi
answers 0 "" verify default.lithe --against "$small" --json --anim test --frames 2
if cmp -s one_frame.json out; then complain "verify --frames changes nothing"; fi
answers 2 "--frames" verify default.lithe --against "$small" --frames 0
# A bake that sees nothing but the rest pose states what weights of 4 bits do there, which is nothing.
echo '{"poses": [{"nodes": {}}]}' >rest_pose.json
bakes blind --pose-file rest_pose.json --weight-bits 4
answers 1 "are farther away than the stated error" verify blind.lithe --against "$small"
answers 0 "" verify plain.lithe --quiet
[ ! -s out ] || complain "verify --quiet prints"
answers 0 "" export plain.lithe -o with.glb --level 0 --from "$small" --quiet
[ ! -s out ] || complain "export --quiet prints"
answers 0 "" compare with.glb with.glb --anim examples --frames 1 --samples 100 --quiet
answers 0 "" export plain.lithe -o without.glb --level 0 --quiet
answers 1 "examples" compare without.glb without.glb --anim examples --frames 1 --samples 100
answers 0 '"clips"' generate column -o column.glb --json
answers 0 "" generate column -o column.glb --quiet
[ ! -s out ] || complain "generate --quiet prints"
cmp column.glb "$characters/column.glb" || complain "the column is not the same twice"

# ---- compare -------------------------------------------------------------------------------------------------------
# compares NAME ARGUMENTS...: the report of comparing the small character with its coarsest level, in NAME.json
compares() {
  local name=$1
  shift
  answers 0 "" compare "$small" with.glb --samples 200 --json "$name.json" --quiet "$@"
}
compares middle --anim test --frames 2
compares ends --anim test --frames 2 --phase ends
is ends.json "frames[0].time" 0.0
orders 0 "$(json middle.json "frames[0].time")" "--phase mid, the first frame"
compares between --anim test --frames 2 --phase between
awk -v t="$(json between.json "frames[1].time")" 'BEGIN { d = t * 30 - int(t * 30) - 0.5; exit !(d < 1e-6 && d > -1e-6) }' ||
  complain "--phase between is at $(json between.json "frames[1].time") s, not halfway between thirtieths"
compares poses --anim sampled --frames 1
compares later --anim sampled --frames 1 --first-pose 9
if cmp -s poses.json later.json; then complain "--first-pose changes nothing"; fi
compares beyond --anim test --frames 2 --beyond 0
orders 0.5 "$(json beyond.json mean_of_frames.beyond)" "--beyond 0 counts nearly all samples"
compares beyond --anim test --frames 2 --beyond 1000
is beyond.json mean_of_frames.beyond 0.0
answers 0 "farther than 1000 units: 0.000 % of the samples" compare "$small" with.glb --anim test --frames 1 --samples 100 --beyond 1000
compares number --anim 1 --frames 2 --threads 1
cmp middle.json number.json || complain "--anim 1 is not the second clip, or --threads changes the result"
compares seed --anim test --frames 2 --seed 2
if cmp -s middle.json seed.json; then complain "--seed changes nothing"; fi
compares rest --anim none
compares every --anim test --frames 0
count() { grep -c '"clip"' "$1" || true; }
[ "$(count rest.json)" = 1 ] || complain "the rest pose has $(count rest.json) frames"
[ "$(count middle.json)" = 2 ] || complain "--frames 2 gave $(count middle.json) frames"
[ "$(count every.json)" -gt 30 ] || complain "--frames 0 gave $(count every.json) frames"
answers 0 "rms" compare "$small" with.glb --anim sampled --frames 1 --samples 100
answers 0 "" compare "$small" with.glb --anim none --samples 100 --quiet --fail-above-rms 1
cat >rigid.gltf <<'END'
{"asset": {"version": "2.0"}, "nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
 "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
 "bufferViews": [{"buffer": 0, "byteLength": 36}],
 "buffers": [{"byteLength": 36, "uri": "data:;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]}
END
answers 1 "no skinned triangle" compare rigid.gltf rigid.gltf --samples 10
answers 0 "rms" compare rigid.gltf rigid.gltf --samples 10 --include-rigid
finish
