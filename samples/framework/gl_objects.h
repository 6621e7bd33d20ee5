// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// OpenGL 4.3 core, called directly: libOpenGL exports it. Small owners of what the samples make there.
/// Everything here needs a current context, in the constructor and in the destructor.
#pragma once

#ifndef GL_GLEXT_PROTOTYPES
#define GL_GLEXT_PROTOTYPES
#endif
#include <GL/glcorearb.h>

#include <glm/glm.hpp>
#include <span>
#include <string>

#include "picture.h"

namespace sample {

/// A buffer object of fixed size.
class Buffer {
 public:
  explicit Buffer(size_t bytes);
  ~Buffer();
  Buffer(const Buffer&) = delete;
  Buffer& operator=(const Buffer&) = delete;

  GLuint id() const { return id_; }
  size_t bytes() const { return bytes_; }

  /// Replaces the beginning. The span must fit.
  template <class T>
  void write(std::span<const T> values) {
    writeBytes(values.data(), values.size_bytes());
  }

  /// A window on [offset, offset + bytes) to write to, where nothing that is being drawn reads. Close it with unmap().
  void* mapUnread(size_t offset, size_t bytes);
  void unmap();

 private:
  void writeBytes(const void* data, size_t bytes);

  GLuint id_ = 0;
  size_t bytes_ = 0;
};

/// A linked program. Throws Error with the driver's message when the sources are wrong.
class Program {
 public:
  Program(const std::string& vertex_source, const std::string& fragment_source);
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void use() const;

 private:
  GLuint id_ = 0;
};

/// What is drawn to without a window: a multisampled picture and the plain one that it is resolved to.
class Target {
 public:
  Target(int width, int height, int samples);
  ~Target();
  Target(const Target&) = delete;
  Target& operator=(const Target&) = delete;

  int width() const { return width_; }
  int height() const { return height_; }

  /// Draw to the multisampled picture.
  void bind() const;
  /// Resolve it and draw to the plain picture from now on.
  void resolve() const;
  /// The plain picture onto the window.
  void show() const;
  Picture read() const;

 private:
  int width_, height_;
  GLuint framebuffers_[2] = {}, renderbuffers_[3] = {};
};

/// A square depth texture that compares when it is sampled.
class ShadowMap {
 public:
  explicit ShadowMap(int size);
  ~ShadowMap();
  ShadowMap(const ShadowMap&) = delete;
  ShadowMap& operator=(const ShadowMap&) = delete;

  int size() const { return size_; }
  void bind() const;  ///< draw depth to it, cleared
  void bindTexture(GLuint unit) const;

 private:
  int size_;
  GLuint texture_ = 0, framebuffer_ = 0;
};

/// Throws Error when OpenGL has noted an error since the last call.
void checkGl(const std::string& where);

}  // namespace sample
