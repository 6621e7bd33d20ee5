// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// Whether lithe reaches its targets beside the best shipped tool.
import { bestOf, figureOf, groupsOf, isBehind, isMeasured, litheOf, table } from './figures.mjs';
import { UNSHIPPED, caseName, characterTable, definedOf, meanOf, quotientOf, shippedOf, whyLeftOut, worstOf } from './quotients.mjs';

const WORST = 1.3;
// mean: what the geometric mean of lithe / best may be at most; without it a figure is only told. worst: no single case may be above WORST.
const TARGETS = [
  { key: 'rms', name: 'RMS', mean: 0.42, worst: true },
  { key: 'hausdorff', name: 'Hausdorff', mean: 0.75, worst: true },
  { key: 'normals', name: 'normals', mean: 0.85, worst: true },
  { key: 'silhouette', name: 'silhouette' },
  { key: 'uv', name: 'uv RMS', mean: 1 },
  { key: 'uvMedian', name: 'uv median', mean: 1 },
  { key: 'uvStretch', name: 'uv stretch', mean: 1 },
];
const FLIPPED = figureOf('flipped');

const verdictOf = (value, most) => (Number.isNaN(value) ? '-' : value <= most ? 'holds' : '**missed**');

export function flippedBehind(rows) {
  return rows.filter((row) => isBehind(FLIPPED, litheOf(row).flipped, bestOf(shippedOf(row), 'flipped').flipped));
}

function meanTable(groups, targets) {
  const rows = groups.at(-1)[1], shown = (value) => (Number.isNaN(value) ? '-' : value.toFixed(3));
  const body = targets.map(({ key, name, mean }) => [name, ...groups.map(([, group]) => shown(meanOf(group, key))),
    definedOf(rows, key).length, ...(mean ? [`<= ${mean}`, verdictOf(meanOf(rows, key), mean)] : ['-', '-'])]);
  const counts = groups.map(([, group]) => `${flippedBehind(group).length} of ${group.length}`);
  body.push(['flipped area: cases above', ...counts, rows.length, '0', verdictOf(flippedBehind(rows).length, 0)]);
  return table(['figure', ...groups.map(([name]) => name), 'cases', 'target', 'verdict'], body, 1);
}

function worstTable(groups) {
  const rows = groups.at(-1)[1], shown = ({ value, row }) => (row ? `${value.toFixed(2)} ${row.name}` : '-');
  const body = TARGETS.filter((target) => target.worst).map(({ key, name }) => {
    const worst = worstOf(rows, key);
    return [name, ...groups.slice(0, -1).map(([, group]) => shown(worstOf(group, key))),
      worst.row ? `${worst.value.toFixed(2)} ${caseName(worst.row)}, ${worst.peer}` : '-', `<= ${WORST}`, verdictOf(worst.value, WORST)];
  });
  return table(['figure', ...groups.map(([name]) => name), 'target', 'verdict'], body, 1);
}

// Every case that keeps a target from holding on its own: above WORST, or more flipped area.
function missesOf(rows) {
  const above = TARGETS.filter((target) => target.worst).flatMap(({ key, name }) => definedOf(rows, key).filter(({ value }) => value > WORST)
    .map(({ row, value, peer }) => `* ${name}: ${caseName(row)}, ${value.toFixed(2)} of ${peer}`));
  const flipped = flippedBehind(rows).map((row) => {
    const best = bestOf(shippedOf(row), 'flipped');
    return `* flipped area: ${caseName(row)}, ${litheOf(row).flipped.toFixed(3)} % beside ${best.flipped.toFixed(3)} % of ${best.method}`;
  });
  return [...above, ...flipped];
}

// What is in no figure, or not in all of them, and why.
function leftOutOf(all, rows, targets) {
  const cases = all.filter(whyLeftOut).map((row) => `* ${caseName(row)}: ${whyLeftOut(row)}`);
  const quotients = targets.flatMap(({ key, name }) => rows.map((row) => quotientOf(row, key)).filter(({ why }) => why)
    .map(({ row, why }) => `* ${name} of ${caseName(row)}: ${why}`));
  return [...cases, ...quotients];
}

const section = (title, lines) => `${title}\n${lines.length ? lines.join('\n') : '* none'}\n`;

export function verdictOn(all) {
  const rows = all.filter((row) => !whyLeftOut(row)), groups = groupsOf(rows), targets = TARGETS.filter((target) => isMeasured(all, target));
  if (!rows.length) return section('There is nothing to judge:', leftOutOf(all, rows, targets));
  return [
    `lithe beside the best *shipped* tool per figure and per case (every method but ${UNSHIPPED.join(' and ')}, which nobody ships), within 2 % of the count.`,
    'Geometric means of lithe / best; below 1 lithe is better:\n', meanTable(groups, targets),
    '\nThe worst case of each, and over all beside which tool:\n', worstTable(groups),
    section('\nCases that miss a target:\n', missesOf(rows)),
    section('Left out:\n', leftOutOf(all, rows, targets)),
    ...targets.map(({ key, name }) => characterTable(all, key, `lithe / best shipped by character, ${name}`)),
  ].join('\n');
}
