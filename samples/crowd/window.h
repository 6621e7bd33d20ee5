// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The crowd in a window, in real time.
#pragma once

#include "options.h"

/// Runs until the window is closed. Throws sample::Error where there is no display or the sample was built without
/// GLFW.
void runWindow(const Options& options);
