// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// The shipped tools with the least RMS of a file's first row, best first: node best.mjs ROWS HOW_MANY
import fs from 'node:fs';
import { shippedOf } from './quotients.mjs';

const [file, most] = process.argv.slice(2), [row] = JSON.parse(fs.readFileSync(file, 'utf8'));
const best = shippedOf(row).sort((a, b) => a.rms - b.rms).slice(0, Number(most));
console.log(best.map((peer) => peer.method).join('\n'));
