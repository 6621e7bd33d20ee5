// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "attribute_choice.h"

#include <algorithm>

namespace lithe::bake {
namespace {

template <typename T>
bool varies(const std::vector<T>& values) {
  return std::any_of(values.begin(), values.end(), [&](const T& value) { return value != values.front(); });
}

std::string range(const char* name, uint32_t first, uint32_t end) {
  std::string text = name + std::to_string(first);
  return end - first > 1 ? text + " to " + name + std::to_string(end - 1) : text;
}

AttributeSet defaultAttributes(const Model& model, std::vector<std::string>& warnings) {
  AttributeSet chosen;
  chosen.normal = model.attributes.normal;
  chosen.tangent = model.attributes.tangent;
  chosen.uv_sets = model.attributes.uv_sets > 0 && varies(model.uvs[0]) ? 1 : 0;
  chosen.color_sets = model.attributes.color_sets > 0 && varies(model.colors[0]) ? 1 : 0;
  std::string dropped;
  if (model.attributes.uv_sets > std::max(chosen.uv_sets, 1u))
    dropped = range("uv", std::max(chosen.uv_sets, 1u), model.attributes.uv_sets);
  for (uint32_t s = chosen.color_sets; s < model.attributes.color_sets; ++s)
    if (varies(model.colors[s])) dropped += (dropped.empty() ? "color" : ", color") + std::to_string(s);
  if (!dropped.empty()) warnings.push_back(dropped + " left out; name them in --attributes to keep them");
  return chosen;
}

}  // namespace

AttributeSet chooseAttributes(const Model& model, const std::vector<std::string>& names,
                              std::vector<std::string>& warnings) {
  if (names.empty()) return defaultAttributes(model, warnings);
  AttributeSet chosen;
  for (const std::string& name : names) {
    auto lacks = [&name]() { return Error("--attributes: the model has no " + name + ": leave it out"); };
    auto set = [&](const char* prefix, uint32_t available, uint32_t& count) {
      const std::string head = prefix;
      if (name.rfind(head, 0) != 0 || name.size() != head.size() + 1 || name.back() < '0' || name.back() > '9')
        return false;
      const uint32_t index = static_cast<uint32_t>(name.back() - '0');
      if (index >= available) throw lacks();
      count = std::max(count, index + 1);
      return true;
    };
    if (name == "normal" || name == "tangent") {
      const bool normal = name == "normal";
      if (!(normal ? model.attributes.normal : model.attributes.tangent)) throw lacks();
      (normal ? chosen.normal : chosen.tangent) = true;
    } else if (!set("uv", model.attributes.uv_sets, chosen.uv_sets) &&
               !set("color", model.attributes.color_sets, chosen.color_sets)) {
      throw Error("--attributes: unknown attribute '" + name + "': use normal, tangent, uv0 to uv7, color0, color1");
    }
  }
  return chosen;
}

}  // namespace lithe::bake
