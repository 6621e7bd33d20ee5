// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "lithe/bake/generate.h"

#include <array>

#include "characters.h"

namespace lithe::bake {
namespace {

struct Generator {
  const char* name;
  Model (*make)();
};

constexpr std::array kGenerators = {
    Generator{"column", generateColumn},
    Generator{"centipede", generateCentipede},
    Generator{"figure", generateFigure},
};

}  // namespace

std::vector<std::string> generatorNames() {
  std::vector<std::string> names;
  for (const Generator& generator : kGenerators) names.emplace_back(generator.name);
  return names;
}

Model generate(std::string_view name) {
  std::string known;
  for (const Generator& generator : kGenerators) {
    if (name == generator.name) return generator.make();
    known += (known.empty() ? "" : ", ") + std::string(generator.name);
  }
  throw Error("generate: there is no built-in character named '" + std::string(name) + "'; choose one of " + known +
              ".");
}

}  // namespace lithe::bake
