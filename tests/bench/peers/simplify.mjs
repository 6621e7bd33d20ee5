// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// meshoptimizer and gltfpack on a skinned character, without an error limit, to a share of its skinned triangles.
import { spawnSync } from 'node:child_process';
import { fileURLToPath } from 'node:url';
import { MeshoptSimplifier } from 'meshoptimizer';
import { SurfaceSkins, capped, weightVectors } from './attributes.mjs';
import { nodeWorlds, posedPositions, skinnedPrimitives, trainingFrames } from './character.mjs';
import { GltfFile } from './glb.mjs';

const NO_LIMIT = 3.4e38, PROTECT = 2, TOLERANCE = 1.02;

// weights: of normals, uvs, and skins or posed positions. `column` is tuned for the column of the literature.
export const METHODS = {
  meshopt: {},
  'meshopt-attr': { weights: [0.5, 0.1, 1], column: [0.5, 0, 4] },
  'meshopt-update': { weights: [0.2, 0.05, 1], column: [0, 0, 4], update: true },
  'meshopt-poses': { weights: [0.1, 0.05, 1], column: [0, 0, 4], poses: true },
  'meshopt-poses-update': { weights: [0.1, 0.05, 1], column: [0, 0, 4], poses: true, update: true },
  gltfpack: { flags: [] },
  'gltfpack-sv': { flags: ['-sv'] },
};

export async function simplify(input, output, method, ratio, options) {
  if (METHODS[method].flags) return runGltfpack(input, output, ratio, METHODS[method].flags);
  await MeshoptSimplifier.ready;
  const file = new GltfFile(input), parts = skinnedPrimitives(file);
  for (const skin of new Set(parts.map((part) => part.skin))) {
    simplifySkin(file, parts.filter((part) => part.skin === skin), METHODS[method], ratio, options);
  }
  file.write(output);
}

function runGltfpack(input, output, ratio, flags) {
  const cli = fileURLToPath(new URL('node_modules/gltfpack/cli.js', import.meta.url));
  const ran = spawnSync(process.execPath, [cli, '-i', input, '-o', output, '-si', String(ratio), '-se', '1', '-kn', '-km', '-kv', '-noq', ...flags], { encoding: 'utf8' });
  if (ran.status !== 0) throw new Error(`gltfpack: ${ran.stderr || ran.stdout}`);
}

// All primitives of a skin as one mesh; exact duplicates within a primitive are one vertex.
function joined(parts) {
  const mesh = { source: [], indices: [], positions: [], skins: [] };
  parts.forEach((part, p) => {
    const known = new Map(), number = new Int32Array(part.count).fill(-1);
    for (const v of part.indices) {
      if (number[v] < 0) {
        const key = [...part.positions.subarray(v * 3, v * 3 + 3), ...part.normals.subarray(v * 3, v * 3 + 3), ...part.uvs.subarray(v * 2, v * 2 + 2), part.skins[v]].join();
        if (!known.has(key)) {
          known.set(key, mesh.source.push([p, v]) - 1);
          mesh.positions.push(...part.positions.subarray(v * 3, v * 3 + 3));
          mesh.skins.push(part.skins[v]);
        }
        number[v] = known.get(key);
      }
      mesh.indices.push(number[v]);
    }
  });
  mesh.positions = Float32Array.from(mesh.positions);
  mesh.indices = Uint32Array.from(mesh.indices);
  return mesh;
}

// Where primitives meet, permissive simplification must not mix them.
function borderLocks(mesh) {
  const owner = new Map(), key = (i) => mesh.positions.subarray(i * 3, i * 3 + 3).join();
  mesh.source.forEach(([p], i) => owner.set(key(i), (owner.get(key(i)) ?? p) === p ? p : -1));
  return Uint8Array.from(mesh.source, (_, i) => (owner.get(key(i)) === -1 ? PROTECT : 0));
}

function extraAttributes(file, parts, mesh, method, options) {
  if (!method.poses) return weightVectors(mesh.skins, file.json.skins[parts[0].skin].joints.length);
  const frames = trainingFrames(file, options.clip, options.frames, options.phase), size = frames.length * 3;
  const extent = (posed) => Math.max(...[0, 1, 2].map((k) => posed.reduce(([lo, hi], x, i) => (i % 3 === k ? [Math.min(lo, x), Math.max(hi, x)] : [lo, hi]), [Infinity, -Infinity])).map(([lo, hi]) => hi - lo));
  const scale = 1 / Math.max(...parts.map((part) => extent(posedPositions(file, part, nodeWorlds(file, null))))), rows = new Float32Array(mesh.source.length * size);
  frames.forEach((frame, f) => {
    const worlds = nodeWorlds(file, frame), posed = parts.map((part) => posedPositions(file, part, worlds));
    mesh.source.forEach(([p, v], i) => { for (let k = 0; k < 3; k++) rows[i * size + f * 3 + k] = posed[p][v * 3 + k] * scale; });
  });
  return { rows, size, exact: false };
}

function attributesOf(file, parts, mesh, method, options) {
  const [normal, uv, skin] = options.column ? method.column : method.weights, extra = extraAttributes(file, parts, mesh, method, options);
  const stride = 5 + extra.size, rows = new Float32Array(mesh.source.length * stride);
  const lanes = [[], []];
  mesh.source.forEach(([p, v], i) => {
    rows.set(parts[p].normals.subarray(v * 3, v * 3 + 3), i * stride);
    rows.set(parts[p].uvs.subarray(v * 2, v * 2 + 2), i * stride + 3);
    rows.set(extra.rows.subarray(i * extra.size, (i + 1) * extra.size), i * stride + 5);
    for (let k = 0; k < 2; k++) lanes[k].push(parts[p].uvs[v * 2 + k]);
  });
  const extent = lanes.reduce((most, lane) => Math.max(most, lane.reduce((a, b) => Math.max(a, b)) - lane.reduce((a, b) => Math.min(a, b))), 1);
  const weights = [normal, normal, normal, uv / extent, uv / extent, ...Array(extra.size).fill(skin)];
  return { rows, stride, weights, exact: extra.exact };
}

// Plain first; where that stops short of the count, permissive, then with small components pruned.
function simplifySkin(file, parts, method, ratio, options) {
  const mesh = joined(parts), target = Math.round((mesh.indices.length / 3) * ratio) * 3, locks = borderLocks(mesh);
  const plain = { rows: new Float32Array(mesh.source.length), stride: 1, weights: [0], exact: false };
  const attributes = method.weights ? attributesOf(file, parts, mesh, method, options) : plain;
  for (const flags of [[], ['Permissive'], ['Permissive', 'Prune']]) {
    const work = { indices: mesh.indices.slice(), positions: mesh.positions.slice(), rows: attributes.rows.slice() };
    const how = [work.indices, work.positions, 3, work.rows, attributes.stride, attributes.weights, flags.length ? locks : null, target, NO_LIMIT, flags];
    if (method.update) work.indices = work.indices.subarray(0, MeshoptSimplifier.simplifyWithUpdate(...how)[0]);
    else if (method.weights || flags.length) work.indices = MeshoptSimplifier.simplifyWithAttributes(...how)[0];
    else work.indices = MeshoptSimplifier.simplify(work.indices, work.positions, 3, target, NO_LIMIT)[0];
    if (work.indices.length > target * TOLERANCE + 6 && flags.length < 2) continue;
    if (method.update) takeOver(parts, mesh, work, attributes);
    return writeBack(file, parts, mesh, work.indices, method.update);
  }
}

// Moved vertices go back to the primitives they came from, with skins cut to four joints.
function takeOver(parts, mesh, { indices, positions, rows }, { stride, exact }) {
  const surface = exact ? null : new SurfaceSkins(mesh.positions, mesh.indices, mesh.skins);
  for (const i of new Set(indices)) {
    const [p, v] = mesh.source[i], row = rows.subarray(i * stride, (i + 1) * stride), point = positions.subarray(i * 3, i * 3 + 3);
    const length = Math.hypot(row[0], row[1], row[2]) || 1;
    parts[p].positions.set(point, v * 3);
    parts[p].normals.set(row.subarray(0, 3).map((x) => x / length), v * 3);
    parts[p].uvs.set(row.subarray(3, 5), v * 2);
    const skin = capped(exact ? Array.from(row.subarray(5), (weight, joint) => [joint, weight]) : surface.at(point), 4);
    if (skin.length) parts[p].skins[v] = skin;
  }
}

function writeBack(file, parts, mesh, indices, update) {
  const corners = parts.map(() => []);
  for (let t = 0; t < indices.length; t += 3) {
    for (let k = 0; k < 3; k++) corners[mesh.source[indices[t]][0]].push(mesh.source[indices[t + k]][1]);
  }
  parts.forEach((part, p) => {
    const at = part.primitive.attributes;
    part.primitive.indices = file.appendIndices(corners[p].length ? corners[p] : [0, 0, 0]);
    if (!update) return;
    at.POSITION = file.appendVertices(part.positions, 'VEC3', true);
    if (at.NORMAL !== undefined) at.NORMAL = file.appendVertices(part.normals, 'VEC3');
    if (at.TEXCOORD_0 !== undefined) at.TEXCOORD_0 = file.appendVertices(part.uvs, 'VEC2');
    const four = (pick) => part.skins.flatMap((skin) => [0, 1, 2, 3].map((k) => (k < skin.length ? skin[k][pick] : 0)));
    at.JOINTS_0 = file.appendJoints(four(0));
    at.WEIGHTS_0 = file.appendVertices(four(1), 'VEC4');
    delete at.JOINTS_1;
    delete at.WEIGHTS_1;
  });
}
