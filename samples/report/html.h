// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Pieces of a self-contained HTML page.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

/// "&" and "<" and quotes as entities.
std::string escaped(const std::string& text);
/// "1,234,567"
std::string grouped(uint64_t value);
/// printf for one number, such as "%.2f".
std::string number(const char* pattern, double value);
/// "12.3 KB" or "1.23 MB", decimal.
std::string bytesText(uint64_t bytes);

/// An <img> with the picture inside it, as JPEG. Throws sample::Error when the file is missing.
std::string embeddedImage(const std::filesystem::path& png, const std::string& description);

/// A table; the cells are HTML.
std::string htmlTable(const std::vector<std::string>& head, const std::vector<std::vector<std::string>>& rows);

/// The page around a body.
std::string htmlPage(const std::string& title, const std::string& body);
