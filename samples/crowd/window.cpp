// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "window.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "error.h"

#ifdef LITHE_SAMPLES_GLFW
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "camera_path.h"
#include "viewer.h"

namespace {

constexpr double kLongestStep = 0.1;  ///< seconds: a window that was held still does not leap

struct Window {
  explicit Window(const Options& options) {
    if (!glfwInit()) throw sample::Error("there is no display to open a window on");
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_RESIZABLE, GLFW_FALSE);
    handle = glfwCreateWindow(options.width, options.height, "lithe: a streamed crowd", nullptr, nullptr);
    if (!handle) throw sample::Error("this display has no OpenGL 4.3");
    glfwMakeContextCurrent(handle);
    glfwSwapInterval(1);
  }
  ~Window() { glfwTerminate(); }
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  bool down(int key) const { return glfwGetKey(handle, key) == GLFW_PRESS; }

  GLFWwindow* handle = nullptr;
};

/// A key that switches something each time it goes down.
class Toggle {
 public:
  Toggle(int key, bool on) : key_(key), on_(on) {}

  bool update(const Window& window) {
    const bool down = window.down(key_);
    if (down && !was_down_) on_ = !on_;
    was_down_ = down;
    return on_;
  }

 private:
  int key_;
  bool on_, was_down_ = false;
};

/// There and back again.
double pathTime(double seconds) {
  const double length = cameraPathSeconds(), around = std::fmod(seconds, 2 * length);
  return std::min(around, 2 * length - around);
}

}  // namespace

void runWindow(const Options& options) {
  const Window window(options);
  Viewer viewer(options);
  Toggle level_colors(GLFW_KEY_L, options.level_colors), paused(GLFW_KEY_P, false);
  double path_seconds = 0, before = glfwGetTime();
  while (!glfwWindowShouldClose(window.handle) && !window.down(GLFW_KEY_ESCAPE)) {
    glfwPollEvents();
    const double now = glfwGetTime(), step = std::min(now - before, kLongestStep);
    before = now;
    if (!paused.update(window)) path_seconds += step;
    const sample::Camera camera = cameraAt(pathTime(path_seconds));
    viewer.advance(step, camera, false);
    viewer.draw(camera, level_colors.update(window));
    viewer.target().show();
    glfwSwapBuffers(window.handle);
  }
}

#else

void runWindow(const Options&) {
  throw sample::Error("this sample was built without GLFW: install libglfw3-dev and build again");
}

#endif
