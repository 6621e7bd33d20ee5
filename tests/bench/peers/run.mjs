// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// Measures, or takes rows that were measured before, and prints them as markdown.
import fs from 'node:fs';
import { parseArgs } from 'node:util';
import { tablesOf } from './table.mjs';
import { verdictOn } from './verdict.mjs';

const text = (fallback) => ({ type: 'string', default: fallback }), flag = { type: 'boolean', default: false };
const { values, positionals } = parseArgs({
  allowPositionals: true,
  options: {
    suite: flag, ratios: text('0.5,0.2,0.1,0.05'), methods: text(''), anim: text('all'), frames: text('10'), train: text('all'), 'train-frames': text('8'), phase: text('mid'),
    column: flag, keep: text(''), json: text(''), from: text(''),
  },
});

// The peers come from npm: rows of a file are shown without them.
const rows = values.from ? JSON.parse(fs.readFileSync(values.from, 'utf8')) : await (await import('./measure.mjs')).measureAll(positionals, values);
if (values.json) fs.writeFileSync(values.json, `${JSON.stringify(rows, null, 1)}\n`);
if (rows.length) console.log(`${tablesOf(rows)}\n${verdictOn(rows)}`);
