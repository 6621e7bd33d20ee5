// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// File names in glTF are URIs (RFC 3986): other characters than the unreserved ones are percent-encoded.
#pragma once

#include <string>

namespace lithe::bake {

std::string percentEncoded(const std::string& name);
/// A '%' that two hexadecimal digits do not follow stands for itself.
std::string percentDecoded(const std::string& uri);

}  // namespace lithe::bake
