// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// The tool as the bench uses it: bake, export at a count of skinned triangles, and the measure that judges everybody.
import { spawnSync } from 'node:child_process';
import fs from 'node:fs';
import { GltfFile } from './glb.mjs';

// A bake without clips samples its poses, and compare samples the same ones first: those judge nobody.
const SAMPLED_BY_THE_BAKE = 15;
const MOST_EXPORTS = 12;

export function lithe(...args) {
  const ran = spawnSync(process.env.LITHE ?? 'lithe', args, { encoding: 'utf8', maxBuffer: 1 << 28 });
  if (ran.status !== 0) throw new Error((ran.stderr || String(ran.error)).trim().split('\n').at(-1));
}

export function bake(file, baked, { train, 'train-frames': poses }) {
  lithe('bake', file, '-o', baked, '--quiet', ...(train === 'all' ? [] : ['--clips', train, '--poses', poses]));
}

// Triangles of the primitives that the peers simplify and compare measures: those with a skin.
export function skinnedTriangles(file) {
  const { json } = new GltfFile(file), meshes = new Set(json.nodes.filter((node) => node.skin !== undefined).map((node) => node.mesh));
  const corners = ({ indices, attributes }) => json.accessors[indices ?? attributes.POSITION].count;
  return [...meshes].flatMap((mesh) => json.meshes[mesh]?.primitives ?? [])
    .filter((primitive) => (primitive.mode ?? 4) === 4 && primitive.attributes.JOINTS_0 !== undefined)
    .reduce((sum, primitive) => sum + corners(primitive) / 3, 0);
}

// The tool counts rigid parts too; the peers leave them alone. So the total is searched whose skinned share is `target`.
export function exportSkinned(file, baked, simplified, target) {
  let total = target, low = 0, high = Infinity;
  for (let tries = 0; tries < MOST_EXPORTS; tries++) {
    lithe('export', baked, '-o', simplified, '--triangles', String(total), '--from', file, '--quiet');
    const reached = skinnedTriangles(simplified);
    if (Math.abs(reached - target) <= Math.max(1, 0.002 * target)) return;
    if (reached < target) low = total;
    else high = total;
    if (high - low <= 1) return;
    total = high === Infinity ? total + Math.max(1, target - reached) : Math.round((low + high) / 2);
  }
}

// Lengths in thousandths of the rest diagonal; flipped area and silhouettes in percent. hausdorff is the largest of the frames, the others
// are means. null: the character has no such attribute.
export function measure(file, simplified, { anim, frames }) {
  const report = `${simplified}.json`, sampled = !new GltfFile(file).json.animations?.length;
  const count = Number(frames) + (sampled ? SAMPLED_BY_THE_BAKE : 0);
  lithe('compare', file, simplified, '--anim', anim, '--frames', String(count), '--json', report, '--quiet');
  const { original, simplified: { triangles }, frames: all } = JSON.parse(fs.readFileSync(report, 'utf8'));
  const judged = all.slice(sampled ? SAMPLED_BY_THE_BAKE : 0);
  const values = (key) => judged.map((frame) => frame.symmetric[key] ?? frame[key] ?? null);
  const mean = (key) => (values(key).includes(null) ? null : values(key).reduce((a, b) => a + b, 0) / judged.length);
  return {
    skinned: original.triangles, triangles, rms: 1e3 * mean('rms'), hausdorff: 1e3 * Math.max(...values('max')),
    normals: mean('normal_degrees'), flipped: 100 * mean('flipped'), silhouette: 100 * mean('silhouette'),
    uv: mean('uv_rms'), uvMedian: mean('uv_median'), uvStretch: mean('uv_stretch'),
  };
}
