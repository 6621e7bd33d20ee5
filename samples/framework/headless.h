// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// OpenGL without a display: EGL's surfaceless platform, drawn in software where there is no GPU.
#pragma once

namespace sample {

class Headless {
 public:
  /// Makes a context of OpenGL 4.3 core or newer current on this thread. Throws Error when there is none.
  Headless();
  ~Headless();
  Headless(const Headless&) = delete;
  Headless& operator=(const Headless&) = delete;

 private:
  void* display_ = nullptr;
  void* context_ = nullptr;
};

}  // namespace sample
