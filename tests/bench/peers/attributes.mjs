// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// What meshoptimizer is told about deformation: weight vectors, their principal components on large rigs, or posed positions.

// meshoptimizer takes 32 floats; normals and uvs need five.
export const MOST_EXTRA = 27;

// Per vertex the weights of the `joints` joints; where that is too long, coordinates along the leading principal components.
export function weightVectors(skins, joints) {
  if (joints <= MOST_EXTRA) {
    const rows = new Float32Array(skins.length * joints);
    skins.forEach((skin, v) => skin.forEach(([joint, weight]) => (rows[v * joints + joint] += weight)));
    return { rows, size: joints, exact: true };
  }
  const basis = principalComponents(skins, joints, MOST_EXTRA), rows = new Float32Array(skins.length * MOST_EXTRA);
  skins.forEach((skin, v) => basis.forEach((axis, d) => (rows[v * MOST_EXTRA + d] = skin.reduce((sum, [j, w]) => sum + w * axis[j], 0))));
  return { rows, size: MOST_EXTRA, exact: false };
}

// Orthogonal iteration on the covariance of the weight vectors, from a fixed start.
function principalComponents(skins, joints, count) {
  const mean = new Float64Array(joints), moment = Array.from({ length: joints }, () => new Float64Array(joints));
  for (const skin of skins) for (const [a, wa] of skin) {
    mean[a] += wa / skins.length;
    for (const [b, wb] of skin) moment[a][b] += (wa * wb) / skins.length;
  }
  for (let a = 0; a < joints; a++) for (let b = 0; b < joints; b++) moment[a][b] -= mean[a] * mean[b];
  let basis = Array.from({ length: count }, (_, d) => Float64Array.from({ length: joints }, (_, j) => Math.sin(1 + d * 12.9898 + j * 78.233)));
  for (let round = 0; round < 150; round++) {
    basis = basis.map((axis) => moment.map((row) => row.reduce((sum, x, j) => sum + x * axis[j], 0)));
    basis.forEach((axis, d) => {
      for (const other of basis.slice(0, d)) {
        const along = axis.reduce((sum, x, j) => sum + x * other[j], 0);
        other.forEach((x, j) => (axis[j] -= along * x));
      }
      const length = Math.hypot(...axis);
      axis.forEach((x, j) => (axis[j] = length > 1e-30 ? x / length : 0));
    });
  }
  return basis;
}

// The `most` largest weights, normalised to sum one.
export function capped(influences, most) {
  const kept = influences.filter(([, weight]) => weight > 1e-4).sort((a, b) => b[1] - a[1] || a[0] - b[0]).slice(0, most);
  const sum = kept.reduce((total, [, weight]) => total + weight, 0);
  return kept.map(([joint, weight]) => [joint, weight / sum]);
}

// Skins for moved vertices: interpolated at the nearest point of the original triangles. Those are sorted along the longest axis and
// looked at outwards from the point, ruled out by bounding spheres; of equally near ones the first in the file counts.
export class SurfaceSkins {
  constructor(positions, indices, skins) {
    Object.assign(this, { positions, indices, skins });
    const spheres = Array.from({ length: indices.length / 3 }, (_, t) => this.sphere(t));
    const extents = [0, 1, 2].map((k) => spheres.reduce((most, s) => Math.max(most, s[k]), -Infinity) - spheres.reduce((least, s) => Math.min(least, s[k]), Infinity));
    this.axis = extents.indexOf(Math.max(...extents));
    this.order = Uint32Array.from(spheres.keys()).sort((a, b) => spheres[a][this.axis] - spheres[b][this.axis] || a - b);
    this.spheres = Float64Array.from([...this.order].flatMap((t) => spheres[t]));
    this.largest = spheres.reduce((most, [, , , radius]) => Math.max(most, radius), 0);
  }
  corners(t) { return [0, 1, 2].map((k) => this.positions.subarray(this.indices[t * 3 + k] * 3, this.indices[t * 3 + k] * 3 + 3)); }
  sphere(t) {
    const corners = this.corners(t), centre = [0, 1, 2].map((k) => (corners[0][k] + corners[1][k] + corners[2][k]) / 3);
    return [...centre, Math.max(...corners.map((c) => Math.hypot(c[0] - centre[0], c[1] - centre[1], c[2] - centre[2])))];
  }

  // The first place in the order that is not before the point.
  placeOf(point) {
    let low = 0, high = this.order.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.spheres[middle * 4 + this.axis] < point[this.axis]) low = middle + 1;
      else high = middle;
    }
    return low;
  }

  nearest(point) {
    const start = this.placeOf(point), s = this.spheres;
    let best = { distance: Infinity, t: Infinity };
    const isBeyond = (i) => i < 0 || i >= this.order.length || Math.abs(s[i * 4 + this.axis] - point[this.axis]) > best.distance + this.largest;
    const look = (i) => {
      const reach = best.distance + s[i * 4 + 3], x = s[i * 4] - point[0], y = s[i * 4 + 1] - point[1], z = s[i * 4 + 2] - point[2];
      if (x * x + y * y + z * z > reach * reach) return;
      const t = this.order[i], found = nearestOnTriangle(point, this.corners(t));
      if (found.distance < best.distance || (found.distance === best.distance && t < best.t)) best = { ...found, t };
    };
    for (let up = start, down = start - 1; !isBeyond(up) || !isBeyond(down); up++, down--) {
      if (!isBeyond(up)) look(up);
      if (!isBeyond(down)) look(down);
    }
    return best;
  }

  at(point) {
    const best = this.nearest(point), mixed = new Map();
    best.weights.forEach((share, k) => {
      for (const [joint, weight] of this.skins[this.indices[best.t * 3 + k]]) mixed.set(joint, (mixed.get(joint) ?? 0) + share * weight);
    });
    return [...mixed];
  }
}

// Barycentric weights of the nearest point: the foot of the perpendicular if it is inside, else the best of the edges.
function nearestOnTriangle(p, corners) {
  const [a, b, c] = corners.map((q) => [q[0] - p[0], q[1] - p[1], q[2] - p[2]]), dot = (u, v) => u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
  const minus = (u, v) => [u[0] - v[0], u[1] - v[1], u[2] - v[2]], u = minus(b, a), v = minus(c, a);
  const uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), au = -dot(a, u), av = -dot(a, v), area = uu * vv - uv * uv;
  const candidates = [];
  if (area > 1e-20 * uu * vv) {
    const s = (vv * au - uv * av) / area, t = (uu * av - uv * au) / area;
    if (s >= 0 && t >= 0 && s + t <= 1) candidates.push([1 - s - t, s, t]);
  }
  if (!candidates.length) [[a, b, 0, 1], [b, c, 1, 2], [c, a, 2, 0]].forEach(([from, to, i, j]) => {
    const edge = minus(to, from), t = Math.min(1, Math.max(0, -dot(from, edge) / (dot(edge, edge) || 1))), weights = [0, 0, 0];
    weights[i] = 1 - t;
    weights[j] += t;
    candidates.push(weights);
  });
  const scored = candidates.map((weights) => ({ weights, distance: Math.hypot(...[0, 1, 2].map((k) => a[k] * weights[0] + b[k] * weights[1] + c[k] * weights[2])) }));
  return scored.reduce((x, y) => (y.distance < x.distance ? y : x));
}
