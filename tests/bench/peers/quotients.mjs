// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// lithe's figures over those of the best shipped tool. The best is taken per figure and per case: no single tool has to be the best at
// everything, so this is the strictest reading.
import { bestOf, figureOf, geometricMean, groupsOf, litheOf, peersOf, percent, table } from './figures.mjs';

export const UNSHIPPED = ['meshopt-poses', 'meshopt-poses-update'];

export const caseName = (row) => `${row.name} ${percent(row.ratio)}`;
export const shippedOf = (row) => peersOf(row).filter((peer) => !UNSHIPPED.includes(peer.method));

// Why a case is in no figure, or nothing.
export function whyLeftOut(row) {
  if (litheOf(row).failed) return 'lithe failed';
  if (litheOf(row).off) return 'lithe is off the count';
  return shippedOf(row).length ? null : 'no shipped tool reached the count';
}

// lithe / best shipped of one case. Two zeros are equal; one zero has no place in a geometric mean.
export function quotientOf(row, key) {
  const { zero = 0, digits } = figureOf(key), lithe = litheOf(row)[key], best = bestOf(shippedOf(row), key), peer = best[key];
  if (lithe === null) return { row, why: 'the character has none' };
  if (lithe <= zero && peer <= zero) return { row, value: 1, peer: best.method };
  if (lithe <= zero || peer <= zero) return { row, why: `no quotient of lithe ${lithe.toFixed(digits)} and ${best.method} ${peer.toFixed(digits)}` };
  return { row, value: lithe / peer, peer: best.method };
}

export const definedOf = (rows, key) => rows.map((row) => quotientOf(row, key)).filter((quotient) => quotient.value !== undefined);
export const meanOf = (rows, key) => geometricMean(definedOf(rows, key).map((quotient) => quotient.value));
export const worstOf = (rows, key) => definedOf(rows, key).reduce((a, b) => (a.value > b.value ? a : b), { value: NaN });

// Per character and share, and over all shares.
export function characterTable(all, key, title) {
  const rows = all.filter((row) => !whyLeftOut(row)), shares = groupsOf(rows).slice(0, -1);
  const shown = (group) => (Number.isNaN(meanOf(group, key)) ? '-' : meanOf(group, key).toFixed(2));
  const body = [...new Set(rows.map((row) => row.name))].map((name) => {
    const ofName = (group) => group.filter((row) => row.name === name);
    return [name, ...shares.map(([, group]) => shown(ofName(group))), shown(ofName(rows))];
  });
  return `${title}:\n\n${table(['character', ...shares.map(([share]) => share), 'all'], body, 1)}\n`;
}
