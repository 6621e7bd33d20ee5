// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Reads the tables of docs/format.md, so that a test can hold the code to the words of the specification.
#pragma once

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace lithe::test {

using SpecRow = std::vector<std::string>;  ///< trimmed cells

/// The specification's lines, searched by the beginnings of its headings.
class Specification {
 public:
  /// @throws std::runtime_error if the file cannot be read
  explicit Specification(const std::string& path) {
    std::ifstream file(path);
    if (!file) throw std::runtime_error("cannot read " + path);
    for (std::string line; std::getline(file, line);) lines_.push_back(line);
  }

  /// The whole line of the only heading that begins with `title` (after its # signs).
  const std::string& heading(const std::string& title) const { return lines_[headingAt(title)]; }

  /// The first line that contains `text`.
  const std::string& line(const std::string& text) const {
    for (const std::string& candidate : lines_)
      if (candidate.find(text) != std::string::npos) return candidate;
    throw std::runtime_error("docs/format.md has no line with '" + text + "'");
  }

  /// The rows of the `index`-th table below a heading, without the row of titles and the dashes below it.
  std::vector<SpecRow> table(const std::string& title, uint32_t index = 0) const {
    size_t at = headingAt(title) + 1;
    for (uint32_t skipped = 0;; ++skipped) {
      while (at < lines_.size() && !isRow(lines_[at]) && !isHeading(lines_[at])) ++at;
      if (at == lines_.size() || isHeading(lines_[at]))
        throw std::runtime_error("docs/format.md has too few tables below '" + title + "'");
      if (skipped == index) break;
      while (isRow(lines_[at])) ++at;
    }
    std::vector<SpecRow> rows;
    for (at += 2; at < lines_.size() && isRow(lines_[at]); ++at) rows.push_back(cells(lines_[at]));
    return rows;
  }

 private:
  static bool isRow(const std::string& line) { return !line.empty() && line[0] == '|'; }
  static bool isHeading(const std::string& line) { return !line.empty() && line[0] == '#'; }

  static SpecRow cells(const std::string& line) {
    SpecRow row;
    for (size_t begin = 1; begin < line.size();) {
      const size_t end = line.find('|', begin);
      if (end == std::string::npos) break;
      std::string cell = line.substr(begin, end - begin);
      while (!cell.empty() && cell.back() == ' ') cell.pop_back();
      row.push_back(cell.substr(std::min(cell.size(), cell.find_first_not_of(' '))));
      begin = end + 1;
    }
    return row;
  }

  size_t headingAt(const std::string& title) const {
    for (size_t at = 0; at < lines_.size(); ++at) {
      const size_t text = lines_[at].find_first_not_of("# ");
      if (isHeading(lines_[at]) && text != std::string::npos && lines_[at].compare(text, title.size(), title) == 0)
        return at;
    }
    throw std::runtime_error("docs/format.md has no heading '" + title + "'");
  }

  std::vector<std::string> lines_;
};

/// docs/format.md.
inline const Specification& spec() {
  static const Specification specification(LITHE_SOURCE_DIR "/docs/format.md");
  return specification;
}

/// Bytes of a type as the tables write it: "u8 x 3", "f32", "28 bytes".
inline uint32_t bytesOfType(const std::string& type) {
  const uint32_t first = static_cast<uint32_t>(std::stoul(type.substr(type.find_first_of("0123456789"))));
  if (type.find("bytes") != std::string::npos) return first;
  const size_t times = type.find(" x ");
  const uint32_t count = times == std::string::npos ? 1 : static_cast<uint32_t>(std::stoul(type.substr(times + 3)));
  return first / 8 * count;
}

/// All numbers of a text, in order; hexadecimal ones and names with digits do not count.
inline std::vector<uint64_t> numbersIn(const std::string& text) {
  std::vector<uint64_t> numbers;
  for (size_t at = 0; at < text.size();) {
    const bool digit = std::isdigit(static_cast<unsigned char>(text[at])) != 0;
    if (!digit) {
      const bool word = std::isalpha(static_cast<unsigned char>(text[at])) != 0;
      ++at;
      while (word && at < text.size() && std::isalnum(static_cast<unsigned char>(text[at]))) ++at;
      continue;
    }
    size_t length = 0;
    numbers.push_back(std::stoull(text.substr(at), &length));
    at += length;
  }
  return numbers;
}

}  // namespace lithe::test
