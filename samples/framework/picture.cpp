// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "picture.h"

#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>

#include <algorithm>

#include "error.h"

namespace sample {

void Picture::flipRows() {
  const size_t stride = size_t{3} * width;
  for (int row = 0; row < height / 2; ++row) {
    std::swap_ranges(&rgb[row * stride], &rgb[(row + 1) * stride], &rgb[(height - 1 - row) * stride]);
  }
}

void writePng(const Picture& picture, const std::filesystem::path& path) {
  if (!stbi_write_png(path.string().c_str(), picture.width, picture.height, 3, picture.rgb.data(), 3 * picture.width)) {
    throw Error(path.string() + ": cannot be written");
  }
}

}  // namespace sample
