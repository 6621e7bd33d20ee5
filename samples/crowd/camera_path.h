// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The way the camera takes: from far above the crowd down to one character's face and out again.
#pragma once

#include <glm/glm.hpp>

#include "stage.h"

/// Seconds from the first point of the path to the last.
double cameraPathSeconds();

/// seconds are clamped to the path.
sample::Camera cameraAt(double seconds);

/// Whether the camera comes so low and close to a point of the ground that nobody should stand there.
bool isInCamerasWay(const glm::vec3& position);
