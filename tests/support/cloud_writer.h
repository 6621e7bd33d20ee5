// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Writes Draco clouds of the runtime's subset byte by byte, right or wrong in any place a test wants: libdraco only
/// writes sound ones. A stream of a page is such a cloud's columns, one after another, without the beginning.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace lithe::test {

using Bytes = std::vector<uint8_t>;

inline void append(Bytes& bytes, const Bytes& more) { bytes.insert(bytes.end(), more.begin(), more.end()); }

inline void appendU32(Bytes& bytes, uint32_t value) {
  for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<uint8_t>(value >> shift));
}

inline void appendVarint(Bytes& bytes, uint32_t value) {
  for (; value >= 0x80; value >>= 7) bytes.push_back(static_cast<uint8_t>(value | 0x80));
  bytes.push_back(static_cast<uint8_t>(value));
}

/// Frequencies per symbol that sum to 2^precision, none of a used symbol zero.
inline std::vector<uint32_t> scaledFrequencies(const std::vector<uint32_t>& symbols, uint32_t precision) {
  const uint32_t most = *std::max_element(symbols.begin(), symbols.end());
  std::vector<uint64_t> counts(most + 1);
  for (uint32_t symbol : symbols) ++counts[symbol];
  std::vector<uint32_t> frequencies(most + 1);
  const int64_t total = int64_t{1} << precision;
  int64_t sum = 0;
  for (uint32_t s = 0; s <= most; ++s) {
    if (counts[s] == 0) continue;
    frequencies[s] = static_cast<uint32_t>(std::max<uint64_t>(1, (counts[s] << precision) / symbols.size()));
    sum += frequencies[s];
  }
  while (sum != total) {
    uint32_t& largest = *std::max_element(frequencies.begin(), frequencies.end());
    const int64_t change = std::max<int64_t>(total - sum, 1 - static_cast<int64_t>(largest));
    largest = static_cast<uint32_t>(largest + change);
    sum += change;
  }
  return frequencies;
}

/// The frequency table: symbol count, then tokens.
inline Bytes ransTable(const std::vector<uint32_t>& frequencies) {
  Bytes bytes;
  appendVarint(bytes, static_cast<uint32_t>(frequencies.size()));
  for (size_t s = 0; s < frequencies.size(); ++s) {
    const uint32_t frequency = frequencies[s];
    if (frequency == 0) {
      uint32_t more = 0;
      while (more < 63 && s + more + 1 < frequencies.size() && frequencies[s + more + 1] == 0) ++more;
      bytes.push_back(static_cast<uint8_t>(more << 2 | 3));
      s += more;
      continue;
    }
    const uint32_t extra = frequency < 1u << 6 ? 0 : frequency < 1u << 14 ? 1 : 2;
    bytes.push_back(static_cast<uint8_t>(frequency << 2 | extra));
    for (uint32_t k = 0; k < extra; ++k) bytes.push_back(static_cast<uint8_t>(frequency >> (8 * k + 6)));
  }
  return bytes;
}

/// The symbols' stream without its size: symbols are written last to first, the state's bytes end it.
inline Bytes ransStream(const std::vector<uint32_t>& symbols, const std::vector<uint32_t>& frequencies,
                        uint32_t precision) {
  std::vector<uint32_t> starts(frequencies.size() + 1);
  for (size_t s = 0; s < frequencies.size(); ++s) starts[s + 1] = starts[s] + frequencies[s];
  const uint64_t lower = uint64_t{4} << precision;
  uint64_t state = lower;
  Bytes bytes;
  for (size_t i = symbols.size(); i-- > 0;) {
    const uint64_t frequency = frequencies[symbols[i]];
    for (; state >= 1024 * frequency; state >>= 8) bytes.push_back(static_cast<uint8_t>(state));
    state = ((state / frequency) << precision) + state % frequency + starts[symbols[i]];
  }
  state -= lower;
  const uint32_t size = state < 1u << 6 ? 1 : state < 1u << 14 ? 2 : state < 1u << 22 ? 3 : 4;
  state |= static_cast<uint64_t>(size - 1) << (8 * size - 2);
  for (uint32_t k = 0; k < size; ++k) bytes.push_back(static_cast<uint8_t>(state >> (8 * k)));
  return bytes;
}

inline Bytes sized(const Bytes& stream) {
  Bytes bytes;
  appendVarint(bytes, static_cast<uint32_t>(stream.size()));
  append(bytes, stream);
  return bytes;
}

/// What libdraco wants before the columns (docs/format.md, "The cloud of a stream").
inline Bytes cloudBeginning(uint32_t records, const std::vector<uint8_t>& components) {
  Bytes bytes = {'D', 'R', 'A', 'C', 'O', 2, 3, 0, 0, 0, 0};
  appendU32(bytes, records);
  bytes.push_back(1);
  appendVarint(bytes, static_cast<uint32_t>(components.size()));
  for (size_t i = 0; i < components.size(); ++i) {
    append(bytes, {4, 5, components[i], 0});
    appendVarint(bytes, static_cast<uint32_t>(i));
  }
  for (size_t i = 0; i < components.size(); ++i) bytes.push_back(1);
  return bytes;
}

/// A column without prediction whose symbols share one table. bit_length decides on the precision as in the runtime.
inline Bytes rawColumn(const std::vector<uint32_t>& symbols, uint8_t bit_length) {
  const uint32_t precision = std::clamp(3u * bit_length / 2, 12u, 20u);
  const std::vector<uint32_t> frequencies = scaledFrequencies(symbols, precision);
  Bytes bytes = {0xfe, 1, 1, bit_length};
  append(bytes, ransTable(frequencies));
  append(bytes, sized(ransStream(symbols, frequencies, precision)));
  return bytes;
}

/// A column without prediction whose records each say how many bits their values have.
inline Bytes taggedColumn(const std::vector<uint32_t>& symbols, uint32_t components) {
  std::vector<uint32_t> tags;
  std::vector<bool> bits;
  for (size_t i = 0; i < symbols.size(); i += components) {
    uint32_t tag = 1;
    for (uint32_t c = 0; c < components; ++c) {
      while (symbols[i + c] >> tag) ++tag;
    }
    tags.push_back(tag);
    for (uint32_t c = 0; c < components; ++c) {
      for (uint32_t b = 0; b < tag; ++b) bits.push_back(symbols[i + c] >> b & 1);
    }
  }
  const std::vector<uint32_t> frequencies = scaledFrequencies(tags, 12);
  Bytes bytes = {0xfe, 1, 0};
  append(bytes, ransTable(frequencies));
  append(bytes, sized(ransStream(tags, frequencies, 12)));
  Bytes packed((bits.size() + 7) / 8);
  for (size_t b = 0; b < bits.size(); ++b) packed[b / 8] |= static_cast<uint8_t>(bits[b] << b % 8);
  append(bytes, packed);
  return bytes;
}

}  // namespace lithe::test
