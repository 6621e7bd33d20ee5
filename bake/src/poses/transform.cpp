// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "lithe/bake/model.h"

namespace lithe::bake {

glm::dmat4 Transform::matrix() const {
  glm::dmat4 m = glm::mat4_cast(rotation);
  for (int axis = 0; axis < 3; ++axis) m[axis] *= scale[axis];
  m[3] = glm::dvec4(translation, 1.0);
  return m;
}

}  // namespace lithe::bake
