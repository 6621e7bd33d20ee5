// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// Simplifies every file with every method and lithe, measures all with `lithe compare`, prints markdown tables.
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { parseArgs } from 'node:util';
import { named, suite } from './cases.mjs';
import { bake, exportSkinned, measure, skinnedTriangles } from './lithe.mjs';
import { METHODS, simplify } from './simplify.mjs';
import { printTables } from './table.mjs';

const TOLERANCE = 0.02;

const text = (fallback) => ({ type: 'string', default: fallback }), flag = { type: 'boolean', default: false };
const { values, positionals } = parseArgs({
  allowPositionals: true,
  options: { suite: flag, ratios: text('0.5,0.2,0.1,0.05'), methods: text(Object.keys(METHODS).join()), anim: text('all'), frames: text('10'), train: text('all'), 'train-frames': text('8'), phase: text('mid'), column: flag, keep: text('') },
});
const folder = values.keep || fs.mkdtempSync(path.join(os.tmpdir(), 'lithe-peers-'));
fs.mkdirSync(folder, { recursive: true });

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

async function measureAll(cases, methods) {
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

const cases = values.suite ? suite(values, folder) : named(positionals, values);
printTables(await measureAll(cases, ['lithe', ...values.methods.split(',')]));
if (!values.keep) fs.rmSync(folder, { recursive: true });
