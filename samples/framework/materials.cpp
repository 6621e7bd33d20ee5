// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "materials.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <string_view>

namespace sample {
namespace {

/// A word in a part's or material's name and what it looks like. The first that occurs counts.
struct NamedLook {
  std::string_view word;
  DrawMaterial material;
};

// Colours are linear; the last of each is gloss, the variation is hue, brightness, saturation.
const std::array kLooks{
    NamedLook{"eye", {{0.75f, 0.74f, 0.72f, 0.9f}, {0, 0, 0, 0}}},
    NamedLook{"hair", {{0.060f, 0.032f, 0.018f, 0.45f}, {0.05f, 0.9f, 0.3f, 0}}},
    NamedLook{"short", {{0.05f, 0.13f, 0.42f, 0.05f}, {0.9f, 0.5f, 0.5f, 0}}},
    NamedLook{"skin", {{0.60f, 0.33f, 0.22f, 0.25f}, {0.04f, 0.7f, 0.15f, 0}}},
    NamedLook{"shell", {{0.30f, 0.055f, 0.02f, 0.8f}, {0.12f, 0.45f, 0.1f, 0}}},
    NamedLook{"flesh", {{0.72f, 0.36f, 0.07f, 0.35f}, {0.06f, 0.3f, 0.1f, 0}}},
    NamedLook{"column", {{0.10f, 0.38f, 0.34f, 0.3f}, {0.45f, 0.3f, 0.3f, 0}}},
};

std::string lowered(std::string_view text) {
  std::string out(text);
  std::transform(out.begin(), out.end(), out.begin(), [](unsigned char c) { return std::tolower(c); });
  return out;
}

/// A colour that only depends on the name (FNV-1a), so that parts can be told apart.
DrawMaterial lookOfUnknown(const std::string& name) {
  uint32_t hash = 2166136261u;
  for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
  const auto channel = [hash](int shift) { return 0.12f + 0.5f * static_cast<float>((hash >> shift) & 255u) / 255.0f; };
  return {{channel(3), channel(11), channel(19), 0.2f}, {0.1f, 0.3f, 0.2f, 0}};
}

DrawMaterial lookOf(const lithe_part& part) {
  const std::string name = lowered(part.name) + " " + lowered(part.material);
  for (const NamedLook& look : kLooks) {
    if (name.find(look.word) != std::string::npos) return look.material;
  }
  return lookOfUnknown(name);
}

}  // namespace

glm::vec3 levelColor(uint32_t level, uint32_t level_count) {
  static constexpr std::array<glm::vec3, 6> kRamp{{{0.03f, 0.07f, 0.45f},
                                                   {0.02f, 0.35f, 0.60f},
                                                   {0.03f, 0.42f, 0.10f},
                                                   {0.65f, 0.55f, 0.02f},
                                                   {0.75f, 0.22f, 0.01f},
                                                   {0.55f, 0.02f, 0.03f}}};
  if (level_count < 2) return kRamp.front();
  const float at = static_cast<float>(level) / static_cast<float>(level_count - 1) * (kRamp.size() - 1);
  const size_t below = std::min(static_cast<size_t>(at), kRamp.size() - 2);
  return glm::mix(kRamp[below], kRamp[below + 1], at - static_cast<float>(below));
}

Materials::Materials(std::span<const Character> characters) {
  for (const Character& character : characters) {
    std::vector<DrawMaterial>& parts = parts_.emplace_back();
    for (const lithe_part& part : character.parts) parts.push_back(lookOf(part));
    level_counts_.push_back(character.info.level_count);
  }
}

DrawMaterial Materials::materialOf(const lithe_draw_key& key, bool by_level) const {
  if (!by_level) return parts_[key.asset][key.part];
  return {glm::vec4(levelColor(key.level, level_counts_[key.asset]), 0.15f), glm::vec4(0)};
}

std::span<const DrawMaterial> Materials::forDraws(const DrawList& list, bool by_level) {
  draws_.clear();
  for (const lithe_draw_key& key : list.keys()) draws_.push_back(materialOf(key, by_level));
  return draws_;
}

}  // namespace sample
