// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Which of a model's attributes a bake carries.
#pragma once

#include <string>
#include <vector>

#include "lithe/bake/model.h"

namespace lithe::bake {

/// Reads a list of names (see BakeOptions::attributes); an empty list chooses what is worth its bytes.
/// Appends a warning for what the model has and the default leaves out. Throws Error for a name that is unknown or that
/// the model lacks.
AttributeSet chooseAttributes(const Model& model, const std::vector<std::string>& names,
                              std::vector<std::string>& warnings);

}  // namespace lithe::bake
