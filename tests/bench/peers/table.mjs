// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// The figures as markdown: one table per figure, what they come to, and every place where a peer is better than lithe.

// factor: a peer's value is also given as a multiple of lithe's. slack: a difference below it is noise, not a lead; of a factor, relative.
const FIGURES = [
  { key: 'rms', title: 'Posed RMS distance, thousandths of the rest diagonal', digits: 3, factor: true, slack: 0.003 },
  { key: 'hausdorff', title: 'Hausdorff distance over all frames, thousandths of the rest diagonal', digits: 2, factor: true, slack: 0.04 },
  { key: 'normals', title: 'Normal deviation, degrees', digits: 2, slack: 0.02 },
  { key: 'flipped', title: 'Flipped area, %', digits: 3, slack: 0.01 },
  { key: 'uv', title: 'uv deviation, RMS', digits: 4, slack: 1e-3 },
  { key: 'uvMedian', title: 'uv deviation, median', digits: 5, slack: 1e-5 },
  { key: 'seconds', title: 'Seconds (lithe: its bake, which serves every count, and the export; wasm for meshopt and gltfpack, files read and written)', digits: 2 },
];

const line = (cells) => `| ${cells.join(' | ')} |`, percent = (ratio) => `${Number((100 * ratio).toPrecision(4))} %`;
const table = (head, rows) => [line(head), line(head.map((_, i) => (i < 2 ? '---' : '---:'))), ...rows.map(line)].join('\n');
const geometricMean = (values) => Math.exp(values.reduce((sum, value) => sum + Math.log(value), 0) / values.length);
const mean = (values) => values.reduce((sum, value) => sum + value, 0) / values.length;

const litheOf = (row) => row.results[0];
const peersOf = (row) => row.results.slice(1).filter((peer) => !peer.failed && !peer.off);

function cell({ key, digits, factor }, result, lithe) {
  if (result.failed) return 'failed';
  const times = factor && result !== lithe && !lithe.failed ? ` (${(result[key] / lithe[key]).toFixed(2)}x)` : '';
  return `${result[key].toFixed(digits)}${times}${result.off ? ` [${result.triangles}]` : ''}`;
}

function figureTable(rows, figure, methods) {
  const body = rows.map((row) => [row.name, percent(row.ratio), ...row.results.map((result) => cell(figure, result, litheOf(row)))]);
  return `${figure.title}:\n\n${table(['character', 'triangles', ...methods], body)}\n`;
}

// What a method's results come to beside lithe's over rows where both reached the count.
function summaryOf(rows, pick) {
  const pairs = rows.map((row) => [litheOf(row), pick(row)]).filter(([lithe, peer]) => peer && !lithe.failed && !lithe.off);
  if (!pairs.length) return null;
  const factor = (key) => `${geometricMean(pairs.map(([lithe, peer]) => peer[key] / lithe[key])).toFixed(2)}x`;
  const more = (key, digits) => mean(pairs.map(([lithe, peer]) => peer[key] - lithe[key])).toFixed(digits);
  return [pairs.length, factor('rms'), factor('hausdorff'), more('normals', 2), more('flipped', 3), more('uv', 4)];
}

function summaryTable(rows, methods) {
  const picks = methods.slice(1).map((method) => [method, (row) => peersOf(row).find((peer) => peer.method === method)]);
  const best = (row, key) => peersOf(row).reduce((a, b) => (b[key] < a[key] ? b : a), { [key]: Infinity });
  picks.push(['best RMS of all', (row) => (peersOf(row).length ? best(row, 'rms') : undefined)]);
  const groups = [...[...new Set(rows.map((row) => row.ratio))].map((ratio) => [percent(ratio), rows.filter((row) => row.ratio === ratio)]), ['all', rows]];
  const body = groups.flatMap(([name, group]) => picks.map(([method, pick]) => [name, method, summaryOf(group, pick)]))
    .filter(([, , summary]) => summary).map(([name, method, summary]) => [name, method, ...summary]);
  const head = ['triangles', 'peer', 'cases', 'RMS / lithe', 'Hausdorff / lithe', 'normals, degrees more', 'flipped, % more', 'uv more'];
  return `Peers beside lithe: geometric means of the quotients, means of the differences; only where both reached the count:\n\n${table(head, body)}\n`;
}

function behind({ key, factor, slack }, row) {
  const lithe = litheOf(row), peers = peersOf(row);
  if (lithe.failed || !peers.length) return [];
  const best = peers.reduce((a, b) => (b[key] < a[key] ? b : a));
  return lithe[key] > (factor ? best[key] * (1 + slack) : best[key] + slack) ? [best] : [];
}

function behindTable(rows) {
  const body = FIGURES.filter((figure) => figure.slack).flatMap((figure) => rows.flatMap((row) => behind(figure, row).map((best) =>
    [row.name, percent(row.ratio), figure.key, litheOf(row)[figure.key].toFixed(figure.digits), best[figure.key].toFixed(figure.digits), best.method, (best.rms / litheOf(row).rms).toFixed(2)])));
  if (!body.length) return 'No peer is better than lithe in any of these figures.\n';
  return `Where the best peer is better than lithe:\n\n${table(['character', 'triangles', 'figure', 'lithe', 'peer', 'which', 'its RMS / lithe'], body)}\n`;
}

export function printTables(rows) {
  if (!rows.length) return;
  const methods = litheOf(rows[0]) && rows[0].results.map((result) => result.method);
  console.log('In square brackets: triangles, where more than 2 % off; such results are in no mean.\n');
  console.log([...FIGURES.map((figure) => figureTable(rows, figure, methods)), summaryTable(rows, methods), behindTable(rows)].join('\n'));
}
