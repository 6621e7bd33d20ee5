// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// Simplifies every case with lithe and every method at every share, and measures all with `lithe compare`.
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { named, suite } from './cases.mjs';
import { bake, exportSkinned, measure, skinnedTriangles } from './lithe.mjs';
import { METHODS, simplify } from './simplify.mjs';

const TOLERANCE = 0.02;

async function timed(work) {
  const start = performance.now();
  await work();
  return (performance.now() - start) / 1000;
}

// One method at one share: its figures, or the reason why there are none.
async function result({ name, file, options }, baked, bakeSeconds, method, ratio) {
  const simplified = `${baked}.${method}.${ratio}.glb`, target = Math.round(skinnedTriangles(file) * ratio);
  const training = { clip: options.train, frames: Math.min(Number(options['train-frames']), 9), phase: options.phase, column: options.column };
  process.stderr.write(`${name}, ${100 * ratio} %, ${method}\n`);
  try {
    const seconds = await timed(() => (method === 'lithe' ? exportSkinned(file, baked, simplified, target) : simplify(file, simplified, method, ratio, training)));
    const figures = measure(file, simplified, options), off = Math.abs(figures.triangles - target) > TOLERANCE * target + 2;
    return { method, ...figures, off, seconds: seconds + (method === 'lithe' ? bakeSeconds : 0) };
  } catch (error) {
    process.stderr.write(`${name}, ${method}, ${ratio}: ${error.message}\n`);
    return { method, failed: error.message };
  }
}

async function measureCases(cases, methods, folder) {
  const rows = [];
  for (const [i, one] of cases.entries()) {
    const baked = path.join(folder, `${i}-${path.basename(one.file)}.lithe`);
    const bakeSeconds = await timed(() => bake(one.file, baked, one.options));
    for (const ratio of one.options.ratios.split(',').map(Number)) {
      const results = [];
      for (const method of methods) results.push(await result(one, baked, bakeSeconds, method, ratio));
      rows.push({ name: one.name, ratio, results });
    }
  }
  return rows;
}

// One row per case and share; its results are lithe's and then every method's.
export async function measureAll(files, options) {
  const folder = options.keep || fs.mkdtempSync(path.join(os.tmpdir(), 'lithe-peers-'));
  fs.mkdirSync(folder, { recursive: true });
  const cases = options.suite ? suite(options, folder) : named(files, options);
  const rows = await measureCases(cases, ['lithe', ...(options.methods || Object.keys(METHODS).join()).split(',')], folder);
  if (!options.keep) fs.rmSync(folder, { recursive: true });
  return rows;
}
