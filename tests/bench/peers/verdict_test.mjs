// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// The verdict on rows whose quotients are worked out by hand.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { quotientOf } from './quotients.mjs';
import { tablesOf } from './table.mjs';
import { flippedBehind, verdictOn } from './verdict.mjs';

const figures = (method, value, more) => ({ method, triangles: 100, rms: value, hausdorff: value, normals: value, flipped: value, silhouette: value, uv: value, uvMedian: value, uvStretch: value, seconds: 1, off: false, ...more });
const row = (name, ratio, ...results) => ({ name, ratio, results });
const lineOf = (text, start) => text.split('\n').filter((line) => line.startsWith(start));

test('the best is taken per figure, and only of what is shipped', () => {
  const one = row('a', 0.5, figures('lithe', 1), figures('meshopt', 4, { hausdorff: 2 }), figures('gltfpack', 2, { hausdorff: 8 }), figures('meshopt-poses', 0.5), figures('meshopt-poses-update', 0.5));
  assert.deepEqual([quotientOf(one, 'rms').value, quotientOf(one, 'rms').peer], [0.5, 'gltfpack']);
  assert.deepEqual([quotientOf(one, 'hausdorff').value, quotientOf(one, 'hausdorff').peer], [0.5, 'meshopt']);
});

test('means are geometric, per share and over all', () => {
  const rows = [row('a', 0.5, figures('lithe', 1), figures('meshopt', 2)), row('b', 0.5, figures('lithe', 1), figures('meshopt', 8)), row('a', 0.2, figures('lithe', 1), figures('meshopt', 4))];
  assert.deepEqual(lineOf(verdictOn(rows), '| RMS')[0], '| RMS | 0.250 | 0.250 | 0.250 | 3 | <= 0.42 | holds |');
});

test('each character has its own quotients', () => {
  const rows = [row('a', 0.5, figures('lithe', 1), figures('meshopt', 2)), row('b', 0.5, figures('lithe', 1), figures('meshopt', 5)), row('a', 0.2, figures('lithe', 1), figures('meshopt', 8))];
  assert.deepEqual([lineOf(verdictOn(rows), '| a')[0], lineOf(verdictOn(rows), '| b')[0]], ['| a | 0.50 | 0.13 | 0.25 |', '| b | 0.20 | - | 0.20 |']);
});

test('a mean above its target is missed', () => {
  const text = verdictOn([row('a', 0.5, figures('lithe', 43), figures('meshopt', 100))]);
  assert.match(lineOf(text, '| RMS')[0], /0\.430 .*\*\*missed\*\*/);
  assert.match(lineOf(text, '| Hausdorff')[0], /0\.430 .* holds/);
});

test('a figure without a target is told and judged by nothing', () => {
  const text = verdictOn([row('a', 0.5, figures('lithe', 3), figures('meshopt', 2))]);
  assert.deepEqual(lineOf(text, '| silhouette'), ['| silhouette | 1.500 | 1.500 | 1 | - | - |']);
});

test('results off the count do not count, and a case without any is named', () => {
  const off = row('a', 0.5, figures('lithe', 2), figures('meshopt', 1, { off: true }), figures('gltfpack', 4)), none = row('b', 0.2, figures('lithe', 1), figures('meshopt', 2, { off: true }));
  assert.equal(quotientOf(off, 'rms').value, 0.5);
  assert.match(verdictOn([off, none]), /\* b 20 %: no shipped tool reached the count/);
  assert.match(verdictOn([row('c', 0.1, figures('lithe', 1, { off: true }), figures('meshopt', 2))]), /\* c 10 %: lithe is off the count/);
});

test('two zeros are equal, and one zero is named', () => {
  const both = row('a', 0.5, figures('lithe', 1, { uvMedian: 0 }), figures('meshopt', 2, { uvMedian: 0 })), one = row('b', 0.5, figures('lithe', 1), figures('meshopt', 2, { uvMedian: 0 }));
  assert.equal(quotientOf(both, 'uvMedian').value, 1);
  assert.equal(quotientOf(one, 'uvMedian').value, undefined);
  const text = verdictOn([both, one]);
  assert.match(text, /\* uv median of b 50 %: no quotient of lithe 1\.00000 and meshopt 0\.00000/);
  assert.match(lineOf(text, '| uv median')[0], /\| 1\.000 \| 1\.000 \| 1 \|/);
});

test('what rounding makes of a zero is a zero', () => {
  const both = row('a', 0.5, figures('lithe', 1, { uvMedian: 1.2e-7 }), figures('meshopt', 2, { uvMedian: 1e-17 })), one = row('b', 0.5, figures('lithe', 1e-4), figures('meshopt', 2, { uvMedian: 1e-17 }));
  assert.equal(quotientOf(both, 'uvMedian').value, 1);
  assert.equal(quotientOf(one, 'uvMedian').value, undefined);
  assert.equal(quotientOf(row('c', 0.5, figures('lithe', 1e-9), figures('meshopt', 2e-9)), 'rms').value, 0.5);
});

test('a figure that a character does not have is named and in no mean', () => {
  const without = row('a', 0.5, figures('lithe', 1, { uv: null }), figures('meshopt', 2, { uv: null })), text = verdictOn([without, row('b', 0.5, figures('lithe', 1), figures('meshopt', 4))]);
  assert.match(text, /\* uv RMS of a 50 %: the character has none/);
  assert.match(lineOf(text, '| uv RMS')[0], /\| 0\.250 \| 0\.250 \| 1 \|/);
});

test('uv stretch is judged, and two textures that are nowhere stretched are equal', () => {
  const rows = [row('a', 0.5, figures('lithe', 1), figures('meshopt', 4)), row('b', 0.5, figures('lithe', 1, { uvStretch: 1e-9 }), figures('meshopt', 4, { uvStretch: 0 }))];
  assert.deepEqual(lineOf(verdictOn(rows), '| uv stretch'), ['| uv stretch | 0.500 | 0.500 | 2 | <= 1 | holds |']);
  assert.match(lineOf(verdictOn([row('a', 0.5, figures('lithe', 3), figures('meshopt', 2))]), '| uv stretch')[0], /\*\*missed\*\*/);
});

test('a figure that a file of older rows lacks is in no table', () => {
  const older = [row('a', 0.5, figures('lithe', 1, { uvStretch: undefined }), figures('meshopt', 4, { uvStretch: undefined }), { method: 'gltfpack', failed: 'why' })];
  for (const text of [verdictOn(older), tablesOf(older)]) assert.doesNotMatch(text, /uv stretch/);
  assert.match(verdictOn(older), /\| uv median \| 0\.250/);
  assert.match(tablesOf([row('a', 0.5, figures('lithe', 1), figures('meshopt', 4))]), /uv stretch, mean ln/);
});

test('the worst case is named and held to its limit', () => {
  const rows = [row('a', 0.5, figures('lithe', 1), figures('meshopt', 100)), row('b', 0.5, figures('lithe', 1.31), figures('meshopt', 1))];
  const text = verdictOn(rows);
  assert.deepEqual(lineOf(text, '| RMS')[1], '| RMS | 1.31 b | 1.31 b 50 %, meshopt | <= 1.3 | **missed** |');
  assert.match(text, /\* RMS: b 50 %, 1\.31 of meshopt/);
  assert.match(lineOf(verdictOn(rows.slice(0, 1)), '| RMS')[1], /0\.01 a .* holds/);
});

test('flipped area counts above noise only', () => {
  const rows = [0.009, 0.011, -1].map((more, i) => row(`c${i}`, 0.5, figures('lithe', 1 + more), figures('meshopt', 1)));
  assert.deepEqual(flippedBehind(rows).map(({ name }) => name), ['c1']);
  assert.match(verdictOn(rows), /\| flipped area: cases above \| 1 of 3 \| 1 of 3 \| 3 \| 0 \| \*\*missed\*\* \|/);
});
