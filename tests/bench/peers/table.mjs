// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// The figures as markdown: one table per figure, what they come to, and every place where a peer is better than lithe.
import { FIGURES, bestOf, geometricMean, groupsOf, isBehind, isMeasured, litheOf, mean, peersOf, percent, table } from './figures.mjs';

function cell({ key, digits, factor }, result, lithe) {
  if (result.failed) return 'failed';
  if (result[key] === null) return '-';
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
  const more = (some, key, digits) => mean(some.map(([lithe, peer]) => peer[key] - lithe[key])).toFixed(digits);
  const uv = pairs.filter(([lithe]) => lithe.uv !== null);
  return [pairs.length, factor('rms'), factor('hausdorff'), more(pairs, 'normals', 2), more(pairs, 'flipped', 3), factor('silhouette'), uv.length ? more(uv, 'uv', 4) : '-'];
}

function summaryTable(rows, methods) {
  const picks = methods.slice(1).map((method) => [method, (row) => peersOf(row).find((peer) => peer.method === method)]);
  picks.push(['best RMS of all', (row) => (peersOf(row).length ? bestOf(peersOf(row), 'rms') : undefined)]);
  const body = groupsOf(rows).flatMap(([name, group]) => picks.map(([method, pick]) => [name, method, summaryOf(group, pick)]))
    .filter(([, , summary]) => summary).map(([name, method, summary]) => [name, method, ...summary]);
  const head = ['triangles', 'peer', 'cases', 'RMS / lithe', 'Hausdorff / lithe', 'normals, degrees more', 'flipped, % more', 'silhouette / lithe', 'uv more'];
  return `Peers beside lithe: geometric means of the quotients, means of the differences; only where both reached the count:\n\n${table(head, body)}\n`;
}

function behind(figure, row) {
  const lithe = litheOf(row), peers = peersOf(row);
  if (lithe.failed || !peers.length || lithe[figure.key] === null) return [];
  const best = bestOf(peers, figure.key);
  return isBehind(figure, lithe[figure.key], best[figure.key]) ? [best] : [];
}

function behindTable(rows, figures) {
  const body = figures.filter((figure) => figure.slack).flatMap((figure) => rows.flatMap((row) => behind(figure, row).map((best) =>
    [row.name, percent(row.ratio), figure.key, litheOf(row)[figure.key].toFixed(figure.digits), best[figure.key].toFixed(figure.digits), best.method, (best.rms / litheOf(row).rms).toFixed(2)])));
  if (!body.length) return 'No peer is better than lithe in any of these figures.\n';
  return `Where the best peer is better than lithe:\n\n${table(['character', 'triangles', 'figure', 'lithe', 'peer', 'which', 'its RMS / lithe'], body)}\n`;
}

export function tablesOf(rows) {
  const methods = litheOf(rows[0]) && rows[0].results.map((result) => result.method);
  const figures = FIGURES.filter((figure) => isMeasured(rows, figure));
  const tables = [...figures.map((figure) => figureTable(rows, figure, methods)), summaryTable(rows, methods), behindTable(rows, figures)];
  return ['In square brackets: triangles, where more than 2 % off; such results are in no mean.\n', ...tables].join('\n');
}
