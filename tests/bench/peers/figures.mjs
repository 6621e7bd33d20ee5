// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// What is measured, what of it counts, and how figures become markdown.

const FLOAT_ROUNDING = 2 ** -22;  // of uvs around 1

// factor: a peer's value is also given as a multiple of lithe's. slack: a difference below it is noise, not a lead; of a factor, relative.
// zero: a value up to it is none at all.
export const FIGURES = [
  { key: 'rms', title: 'Posed RMS distance, thousandths of the rest diagonal', digits: 3, factor: true, slack: 0.003 },
  { key: 'hausdorff', title: 'Hausdorff distance over all frames, thousandths of the rest diagonal', digits: 2, factor: true, slack: 0.04 },
  { key: 'normals', title: 'Normal deviation, degrees', digits: 2, slack: 0.02 },
  { key: 'flipped', title: 'Flipped area, %', digits: 3, slack: 0.01 },
  { key: 'silhouette', title: 'Silhouette that differs, % of its area', digits: 3, factor: true, slack: 0.03 },
  { key: 'uv', title: 'uv deviation, RMS', digits: 4, slack: 1e-3, zero: FLOAT_ROUNDING },
  { key: 'uvMedian', title: 'uv deviation, median', digits: 5, slack: 1e-5, zero: FLOAT_ROUNDING },
  { key: 'uvStretch', title: 'uv stretch, mean ln', digits: 4, slack: 5e-3, zero: FLOAT_ROUNDING },
  { key: 'seconds', title: 'Seconds (lithe: its bake, which serves every count, and the export; wasm for meshopt and gltfpack, files read and written)', digits: 2 },
];

export const figureOf = (key) => FIGURES.find((figure) => figure.key === key);
export const litheOf = (row) => row.results[0];
// Peers that came within 2 % of the count: no others count.
export const peersOf = (row) => row.results.slice(1).filter((peer) => !peer.failed && !peer.off);
export const bestOf = (peers, key) => peers.reduce((a, b) => (b[key] < a[key] ? b : a));

// Whether all that was measured has a figure: rows of an older file may lack one.
export const isMeasured = (rows, { key }) => rows.every((row) => row.results.every((result) => result.failed || result[key] !== undefined));

// Whether a value is above the best peer's by more than noise.
export function isBehind({ factor, slack }, value, best) {
  return value > (factor ? best * (1 + slack) : best + slack);
}

export const geometricMean = (values) => Math.exp(values.reduce((sum, value) => sum + Math.log(value), 0) / values.length);
export const mean = (values) => values.reduce((sum, value) => sum + value, 0) / values.length;

// The rows of each share, and all of them.
export function groupsOf(rows) {
  const shares = [...new Set(rows.map((row) => row.ratio))];
  return [...shares.map((ratio) => [percent(ratio), rows.filter((row) => row.ratio === ratio)]), ['all', rows]];
}

export const percent = (ratio) => `${Number((100 * ratio).toPrecision(4))} %`;
const line = (cells) => `| ${cells.join(' | ')} |`;
// `words` columns from the left are aligned to it.
export const table = (head, rows, words = 2) => [line(head), line(head.map((_, i) => (i < words ? '---' : '---:'))), ...rows.map(line)].join('\n');
