// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// The skinned primitives of a glTF file as arrays, and where a pose puts their vertices.

// One entry per primitive: positions, normals, uvs (3, 3, 2 per vertex), skins ([[joint, weight], ...] per vertex, joints as
// indices into the skin) and indices. Morph targets are taken off: nobody here simplifies them.
export function skinnedPrimitives(file) {
  const primitives = [], seen = new Set();
  for (const node of file.json.nodes ?? []) {
    if (node.mesh === undefined || node.skin === undefined || seen.has(node.mesh)) continue;
    seen.add(node.mesh);
    for (const primitive of file.json.meshes[node.mesh].primitives) {
      if ((primitive.mode ?? 4) !== 4 || primitive.attributes.JOINTS_0 === undefined) continue;
      delete primitive.targets;
      primitives.push(readPrimitive(file, primitive, node.skin));
    }
    delete file.json.meshes[node.mesh].weights;
  }
  if (!primitives.length) throw new Error('no skinned triangles');
  return primitives;
}

function readPrimitive(file, primitive, skin) {
  const at = primitive.attributes, positions = file.read(at.POSITION), count = positions.length / 3;
  const indices = primitive.indices === undefined ? Uint32Array.from({ length: count }, (_, i) => i) : Uint32Array.from(file.read(primitive.indices));
  const normals = at.NORMAL === undefined ? areaNormals(positions, indices) : file.read(at.NORMAL);
  const uvs = at.TEXCOORD_0 === undefined ? new Float64Array(count * 2) : file.read(at.TEXCOORD_0);
  return { primitive, skin, count, positions, normals, uvs, indices, skins: readSkins(file, at, count) };
}

function readSkins(file, at, count) {
  const skins = Array.from({ length: count }, () => []);
  for (let set = 0; at[`JOINTS_${set}`] !== undefined; set++) {
    const joints = file.read(at[`JOINTS_${set}`]), weights = file.read(at[`WEIGHTS_${set}`]);
    for (let i = 0; i < count * 4; i++) if (weights[i] > 0) skins[i >> 2].push([joints[i], weights[i]]);
  }
  for (const skin of skins) {
    const sum = skin.reduce((total, [, weight]) => total + weight, 0);
    if (!skin.length) skin.push([0, 1]);
    else for (const influence of skin) influence[1] /= sum;
  }
  return skins;
}

function areaNormals(positions, indices) {
  const normals = new Float64Array(positions.length), corner = (v) => positions.subarray(v * 3, v * 3 + 3);
  for (let t = 0; t < indices.length; t += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => corner(indices[t + k])), u = [0, 1, 2].map((k) => b[k] - a[k]), v = [0, 1, 2].map((k) => c[k] - a[k]);
    const n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    for (let k = 0; k < 3; k++) for (let axis = 0; axis < 3; axis++) normals[indices[t + k] * 3 + axis] += n[axis];
  }
  for (let i = 0; i < normals.length; i += 3) {
    const length = Math.hypot(normals[i], normals[i + 1], normals[i + 2]) || 1;
    for (let k = 0; k < 3; k++) normals[i + k] /= length;
  }
  return normals;
}

const normalized = (q) => { const length = Math.hypot(...q) || 1; return q.map((x) => x / length); };

function slerp(a, b, t) {
  let cosine = a.reduce((sum, x, i) => sum + x * b[i], 0);
  if (cosine < 0) { b = b.map((x) => -x); cosine = -cosine; }
  if (cosine > 0.9999995) return normalized(a.map((x, i) => x + t * (b[i] - x)));
  const angle = Math.acos(cosine), sine = Math.sin(angle);
  return a.map((x, i) => (Math.sin((1 - t) * angle) * x + Math.sin(t * angle) * b[i]) / sine);
}

// Value of an animation sampler at a time; cubic splines through their values, straight between them: training poses only.
function valueAt({ times, values, interpolation }, size, time, rotation) {
  const cubic = interpolation === 'CUBICSPLINE', key = (k) => Array.from(values.subarray((cubic ? 3 * k + 1 : k) * size).subarray(0, size));
  let k = times.findIndex((x) => x > time);
  if (k === 0 || times.length === 1) return key(0);
  if (k < 0) return key(times.length - 1);
  if (interpolation === 'STEP') return key(k - 1);
  const t = (time - times[k - 1]) / (times[k] - times[k - 1]), a = key(k - 1), b = key(k);
  return rotation ? slerp(normalized(a), normalized(b), t) : a.map((x, i) => x + t * (b[i] - x));
}

function localMatrix({ matrix, translation: t = [0, 0, 0], rotation = [0, 0, 0, 1], scale: s = [1, 1, 1] }) {
  if (matrix) return matrix;
  const [x, y, z, w] = normalized(rotation);
  const axes = [[1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)], [2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)], [2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)]];
  return [...axes.flatMap((axis, i) => [...axis.map((value) => value * s[i]), 0]), ...t, 1];
}

const product = (a, b) => Array.from({ length: 16 }, (_, i) => [0, 1, 2, 3].reduce((sum, k) => sum + a[k * 4 + (i % 4)] * b[(i - (i % 4)) + k], 0));

// Training instants: `count` frames over the clips of that name (`all`: every clip), at their ends or in equal slices.
export function trainingFrames(file, clip, count, phase) {
  const clips = (file.json.animations ?? []).filter((animation) => clip === 'all' || animation.name === clip);
  const chosen = Array.from({ length: count }, (_, i) => clips[Math.floor((i * clips.length) / count)]).filter(Boolean);
  return chosen.map((animation, i) => {
    const same = chosen.filter((other) => other === animation).length, at = i - chosen.indexOf(animation);
    const samplers = animation.samplers.map((s) => ({ times: file.read(s.input), values: file.read(s.output), interpolation: s.interpolation }));
    const begin = Math.min(...samplers.map((s) => s.times[0])), end = Math.max(...samplers.map((s) => s.times.at(-1)));
    const along = phase === 'ends' && same > 1 ? at / (same - 1) : (at + 0.5) / same;
    return { animation, samplers, time: begin + along * (end - begin) };
  });
}

// World matrices of all nodes; no frame: the rest pose.
export function nodeWorlds(file, frame) {
  const local = file.json.nodes.map((node) => ({ ...node }));
  for (const { target, sampler } of frame?.animation.channels ?? []) {
    if (target.node === undefined || target.path === 'weights') continue;
    local[target.node][target.path] = valueAt(frame.samplers[sampler], target.path === 'rotation' ? 4 : 3, frame.time, target.path === 'rotation');
  }
  const worlds = [], parent = [];
  local.forEach((node, i) => (node.children ?? []).forEach((child) => (parent[child] = i)));
  const world = (i) => (worlds[i] ??= parent[i] === undefined ? localMatrix(local[i]) : product(world(parent[i]), localMatrix(local[i])));
  local.forEach((_, i) => world(i));
  return worlds;
}

export function posedPositions(file, part, worlds) {
  const skin = file.json.skins[part.skin], binds = skin.inverseBindMatrices === undefined ? null : file.read(skin.inverseBindMatrices);
  const palette = skin.joints.map((node, j) => (binds ? product(worlds[node], binds.subarray(j * 16, j * 16 + 16)) : worlds[node]));
  const posed = new Float64Array(part.count * 3);
  for (let v = 0; v < part.count; v++) for (const [joint, weight] of part.skins[v]) for (let k = 0; k < 3; k++) {
    const m = palette[joint], p = part.positions;
    posed[v * 3 + k] += weight * (m[k] * p[v * 3] + m[4 + k] * p[v * 3 + 1] + m[8 + k] * p[v * 3 + 2] + m[12 + k]);
  }
  return posed;
}
