// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// A glTF file opened for editing its skinned geometry: accessors are read as plain arrays, new ones are only ever appended.
import fs from 'node:fs';
import path from 'node:path';

const READERS = { 5120: ['getInt8', 1, 127], 5121: ['getUint8', 1, 255], 5122: ['getInt16', 2, 32767], 5123: ['getUint16', 2, 65535], 5125: ['getUint32', 4, 4294967295], 5126: ['getFloat32', 4, 1] };
const COMPONENTS = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT4: 16 };
const ARRAY_BUFFER = 34962, ELEMENT_ARRAY_BUFFER = 34963;

export class GltfFile {
  constructor(file) {
    const bytes = fs.readFileSync(file);
    const binary = bytes.readUInt32LE(0) === 0x46546c67;
    const jsonEnd = binary ? 20 + bytes.readUInt32LE(12) : bytes.length;
    this.json = JSON.parse(bytes.toString('utf8', binary ? 20 : 0, jsonEnd));
    for (const name of this.json.extensionsRequired ?? []) {
      if (/draco|meshopt/.test(name)) throw new Error(`${file}: ${name} is not read here: decompress the file first`);
    }
    const chunk = binary ? bytes.subarray(jsonEnd + 8) : null;
    this.buffers = (this.json.buffers ?? []).map((buffer) => {
      if (buffer.uri === undefined) return chunk;
      if (buffer.uri.startsWith('data:')) return Buffer.from(buffer.uri.slice(buffer.uri.indexOf(',') + 1), 'base64');
      return fs.readFileSync(path.join(path.dirname(file), decodeURIComponent(buffer.uri)));
    });
    this.appended = [];
    this.appendedBytes = 0;
  }

  // The accessor's values one after another; integers stated as normalised become fractions.
  read(index) {
    const accessor = this.json.accessors[index], size = COMPONENTS[accessor.type];
    const [reader, bytes, full] = READERS[accessor.componentType];
    const values = new Float64Array(accessor.count * size);
    const fill = (viewIndex, offset, count, place) => {
      const view = this.json.bufferViews[viewIndex], buffer = this.buffers[view.buffer];
      const data = new DataView(buffer.buffer, buffer.byteOffset), start = (view.byteOffset ?? 0) + offset;
      for (let i = 0; i < count; i++) for (let k = 0; k < size; k++) {
        const value = data[reader](start + i * (view.byteStride ?? size * bytes) + k * bytes, true);
        values[place(i) * size + k] = accessor.normalized ? Math.max(value / full, -1) : value;
      }
    };
    if (accessor.bufferView !== undefined) fill(accessor.bufferView, accessor.byteOffset ?? 0, accessor.count, (i) => i);
    if (accessor.sparse) throw new Error('a sparse base attribute is not read here');
    return values;
  }

  append(typed, type, target, bounds = false) {
    const size = COMPONENTS[type], data = new Uint8Array(typed.buffer, typed.byteOffset, typed.byteLength);
    const componentType = { Float32Array: 5126, Uint32Array: 5125, Uint16Array: 5123 }[typed.constructor.name];
    const view = { buffer: this.buffers.length, byteOffset: this.appendedBytes, byteLength: data.length, target };
    const padding = (4 - (data.length % 4)) % 4;
    this.appended.push(data, new Uint8Array(padding));
    this.appendedBytes += data.length + padding;
    const accessor = { bufferView: this.json.bufferViews.push(view) - 1, componentType, count: typed.length / size, type };
    if (bounds) {
      const lanes = [...Array(size).keys()].map((k) => typed.filter((_, i) => i % size === k));
      accessor.min = lanes.map((lane) => lane.reduce((a, b) => Math.min(a, b)));
      accessor.max = lanes.map((lane) => lane.reduce((a, b) => Math.max(a, b)));
    }
    return this.json.accessors.push(accessor) - 1;
  }
  appendVertices(values, type, bounds) { return this.append(Float32Array.from(values), type, ARRAY_BUFFER, bounds); }
  appendJoints(values) { return this.append(Uint16Array.from(values), 'VEC4', ARRAY_BUFFER); }
  appendIndices(values) { return this.append(Uint32Array.from(values), 'SCALAR', ELEMENT_ARRAY_BUFFER); }

  // One GLB with all buffers in one chunk.
  write(file) {
    const chunks = [], starts = [];
    let length = 0;
    for (const bytes of [...this.buffers, Buffer.concat(this.appended)]) {
      starts.push(length);
      const padding = (4 - (bytes.length % 4)) % 4;
      chunks.push(bytes, Buffer.alloc(padding));
      length += bytes.length + padding;
    }
    for (const view of this.json.bufferViews) {
      view.byteOffset = (view.byteOffset ?? 0) + starts[view.buffer];
      view.buffer = 0;
    }
    this.json.buffers = [{ byteLength: length }];
    const text = Buffer.from(JSON.stringify(this.json)), json = Buffer.concat([text, Buffer.alloc((4 - (text.length % 4)) % 4, ' ')]);
    const word = (...values) => Buffer.from(Uint32Array.from(values).buffer);
    const header = word(0x46546c67, 2, 28 + json.length + length, json.length, 0x4e4f534a);
    fs.writeFileSync(file, Buffer.concat([header, json, word(length, 0x004e4942), ...chunks]));
  }
}
