// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "html.h"

#include <cstdio>

#include "picture.h"

namespace {

constexpr int kJpegQuality = 86;

constexpr char kStyle[] = R"(
:root { color-scheme: light; }
body { font: 15px/1.5 system-ui, sans-serif; color: #1d2229; background: #fff; max-width: 1180px; margin: 0 auto; padding: 24px; }
h1 { font-size: 30px; margin: 0 0 4px; } h2 { font-size: 21px; margin: 40px 0 8px; } h3 { font-size: 17px; margin: 28px 0 6px; }
p { margin: 6px 0 12px; max-width: 80ch; } .quiet { color: #5b6470; }
img { display: block; width: 100%; border-radius: 4px; }
table { border-collapse: collapse; margin: 8px 0 16px; font-variant-numeric: tabular-nums; }
th, td { padding: 3px 14px 3px 0; text-align: right; border-bottom: 1px solid #e3e6ea; white-space: nowrap; }
th { color: #5b6470; font-weight: 500; } th:first-child, td:first-child { text-align: left; }
td img { width: 76px; height: 76px; object-fit: cover; }
.two { display: grid; grid-template-columns: 1fr 1fr; gap: 14px; }
.facts { display: grid; grid-template-columns: repeat(4, 1fr); gap: 14px; margin: 18px 0; }
.facts div { background: #f3f5f8; border-radius: 6px; padding: 12px 14px; } .facts b { display: block; font-size: 22px; }
figure { margin: 0 0 12px; } figcaption { color: #5b6470; font-size: 13px; margin-top: 4px; }
svg { width: 100%; height: auto; } svg text { font: 12px system-ui, sans-serif; fill: #5b6470; }
@media (max-width: 760px) { .two, .facts { grid-template-columns: 1fr; } }
)";

std::string base64(const std::vector<uint8_t>& bytes) {
  static constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (size_t i = 0; i < bytes.size(); i += 3) {
    const size_t left = std::min<size_t>(3, bytes.size() - i);
    uint32_t word = 0;
    for (size_t k = 0; k < 3; ++k) word = word << 8 | (k < left ? bytes[i + k] : 0);
    for (size_t k = 0; k < 4; ++k) text += k <= left ? kDigits[word >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

std::string row(const char* cell, const std::vector<std::string>& cells) {
  std::string html = "<tr>";
  for (const std::string& text : cells) html += std::string("<") + cell + ">" + text + "</" + cell + ">";
  return html + "</tr>\n";
}

}  // namespace

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '"')
      out += "&quot;";
    else
      out += c;
  }
  return out;
}

std::string grouped(uint64_t value) {
  std::string digits = std::to_string(value);
  for (size_t at = digits.size(); at > 3; at -= 3) digits.insert(at - 3, ",");
  return digits;
}

std::string number(const char* pattern, double value) {
  char text[64];
  std::snprintf(text, sizeof text, pattern, value);
  return text;
}

std::string bytesText(uint64_t bytes) {
  const double value = static_cast<double>(bytes);
  return bytes < 1000000 ? number("%.1f KB", value / 1e3) : number("%.2f MB", value / 1e6);
}

std::string embeddedImage(const std::filesystem::path& png, const std::string& description) {
  const std::vector<uint8_t> jpeg = sample::encodeJpeg(sample::readPng(png), kJpegQuality);
  return "<img alt=\"" + escaped(description) + "\" src=\"data:image/jpeg;base64," + base64(jpeg) + "\">";
}

std::string htmlTable(const std::vector<std::string>& head, const std::vector<std::vector<std::string>>& rows) {
  std::string html = "<table>\n" + row("th", head);
  for (const std::vector<std::string>& cells : rows) html += row("td", cells);
  return html + "</table>\n";
}

std::string htmlPage(const std::string& title, const std::string& body) {
  return "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
         "content=\"width=device-width\"><title>" +
         escaped(title) + "</title><style>" + kStyle + "</style></head>\n<body>\n" + body + "</body></html>\n";
}
