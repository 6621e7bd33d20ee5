// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// Simplifies every file with every method and lithe, measures all with `lithe compare`, prints one markdown table.
import { spawnSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { parseArgs } from 'node:util';
import { METHODS, simplify } from './simplify.mjs';

const text = (fallback) => ({ type: 'string', default: fallback });
const { values, positionals: files } = parseArgs({
  allowPositionals: true,
  options: { ratios: text('0.5,0.2,0.1,0.05'), methods: text(Object.keys(METHODS).join()), anim: text('all'), frames: text('10'), train: text('all'), 'train-frames': text('8'), phase: text('mid'), column: { type: 'boolean', default: false }, keep: text('') },
});
const tool = process.env.LITHE ?? 'lithe';
const training = { clip: values.train, frames: Math.min(Number(values['train-frames']), 9), phase: values.phase, column: values.column };
const folder = values.keep || fs.mkdtempSync(path.join(os.tmpdir(), 'lithe-peers-'));
fs.mkdirSync(folder, { recursive: true });

function lithe(...args) {
  const ran = spawnSync(tool, args, { encoding: 'utf8', maxBuffer: 1 << 28 });
  if (ran.status !== 0) throw new Error((ran.stderr || String(ran.error)).trim().split('\n').at(-1));
}

function bake(file, baked) {
  const clips = values.train === 'all' ? [] : ['--clips', values.train, '--poses', values['train-frames']];
  lithe('bake', file, '-o', baked, '--quiet', ...clips);
}

// "rms / largest distance", both in thousandths of the rest diagonal; the triangle count where it is more than 2 % off.
function measure(file, simplified, ratio) {
  const report = `${simplified}.json`;
  lithe('compare', file, simplified, '--anim', values.anim, '--frames', values.frames, '--json', report, '--quiet');
  const { rms_mean, max, original, simplified: { triangles } } = JSON.parse(fs.readFileSync(report, 'utf8'));
  const off = Math.abs(triangles - ratio * original.triangles) > 0.02 * ratio * original.triangles + 2;
  return `${(rms_mean * 1e3).toFixed(3)} / ${(max * 1e3).toFixed(2)}${off ? ` (${triangles})` : ''}`;
}

async function cell(method, file, baked, ratio) {
  const simplified = `${baked}.${method}.${ratio}.glb`;
  try {
    if (method === 'lithe') lithe('export', baked, '-o', simplified, '--ratio', String(ratio), '--from', file, '--quiet');
    else await simplify(file, simplified, method, ratio, training);
    return measure(file, simplified, ratio);
  } catch (error) {
    process.stderr.write(`${file}, ${method}, ${ratio}: ${error.message}\n`);
    return 'failed';
  }
}

const columns = ['lithe', ...values.methods.split(',')], rows = [];
for (const file of files) {
  const baked = path.join(folder, `${path.basename(path.dirname(path.resolve(file)))}-${path.basename(file)}.lithe`);
  bake(file, baked);
  for (const ratio of values.ratios.split(',').map(Number)) {
    const cells = [];
    for (const column of columns) cells.push(await cell(column, file, baked, ratio));
    rows.push([path.basename(file), `${Number((100 * ratio).toPrecision(4))} %`, ...cells]);
  }
}
if (!values.keep) fs.rmSync(folder, { recursive: true });
const line = (cells) => `| ${cells.join(' | ')} |`;
console.log('Posed RMS / largest distance, thousandths of the rest diagonal; triangles in brackets where more than 2 % off.\n');
console.log([line(['file', 'triangles', ...columns]), line(Array(columns.length + 2).fill('---')), ...rows.map(line)].join('\n'));
