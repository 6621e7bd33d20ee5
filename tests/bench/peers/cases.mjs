// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// What is measured: the files of the command line with its options, or the suite.
import fs from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { lithe } from './lithe.mjs';

const SUITE_SHARES = '0.5,0.2,0.1,0.05,0.02';
const SHARED = ['mannequiny.glb', 'sintel.glb', 'shark.glb', 'knight.glb', 'valid_asian_f3.glb'];

// As in the literature: four example poses, judged on a clip that only mixes them, and weights tuned for it.
const COLUMN = { anim: 'test', frames: '60', train: 'examples', 'train-frames': '4', phase: 'ends', column: true };

function generated(name, folder) {
  const file = path.join(folder, `${name}.glb`);
  lithe('generate', name, '-o', file, '--quiet');
  return file;
}

// The built-in figure and column, and the shared characters, if there are any.
export function suite(options, folder) {
  const models = fileURLToPath(new URL('../../../../shared/models', import.meta.url)), common = { ...options, ratios: SUITE_SHARES };
  const files = SHARED.map((name) => path.join(models, name)).filter((file) => fs.existsSync(file));
  if (files.length < SHARED.length) process.stderr.write(`skipped ${SHARED.length - files.length} shared characters: they are not here\n`);
  const cases = files.map((file) => ({ name: path.basename(file), file, options: common }));
  cases.push({ name: 'figure', file: generated('figure', folder), options: common });
  cases.push({ name: 'column', file: generated('column', folder), options: { ...common, ...COLUMN } });
  const column = path.join(models, 'column.glb');
  if (fs.existsSync(column)) cases.push({ name: 'column.glb', file: column, options: { ...common, ...COLUMN } });
  return cases;
}

export const named = (files, options) => files.map((file) => ({ name: path.basename(file), file, options }));
