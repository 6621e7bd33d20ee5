// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "picture.h"

#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#include <stb_image.h>

#include <algorithm>
#include <memory>

#include "error.h"

namespace sample {

void Picture::flipRows() {
  const size_t stride = size_t{3} * width;
  for (int row = 0; row < height / 2; ++row) {
    std::swap_ranges(&rgb[row * stride], &rgb[(row + 1) * stride], &rgb[(height - 1 - row) * stride]);
  }
}

Picture readPng(const std::filesystem::path& path) {
  int width = 0, height = 0, channels = 0;
  const std::unique_ptr<uint8_t, decltype(&stbi_image_free)> pixels(
      stbi_load(path.string().c_str(), &width, &height, &channels, 3), stbi_image_free);
  if (!pixels) throw Error(path.string() + ": " + stbi_failure_reason());
  Picture picture(width, height);
  std::copy_n(pixels.get(), picture.rgb.size(), picture.rgb.begin());
  return picture;
}

std::vector<uint8_t> encodeJpeg(const Picture& picture, int quality) {
  std::vector<uint8_t> bytes;
  const auto append = [](void* context, void* data, int size) {
    const uint8_t* from = static_cast<const uint8_t*>(data);
    static_cast<std::vector<uint8_t>*>(context)->insert(static_cast<std::vector<uint8_t>*>(context)->end(), from,
                                                        from + size);
  };
  stbi_write_jpg_to_func(append, &bytes, picture.width, picture.height, 3, picture.rgb.data(), quality);
  return bytes;
}

void writePng(const Picture& picture, const std::filesystem::path& path) {
  if (!stbi_write_png(path.string().c_str(), picture.width, picture.height, 3, picture.rgb.data(), 3 * picture.width)) {
    throw Error(path.string() + ": cannot be written");
  }
}

}  // namespace sample
