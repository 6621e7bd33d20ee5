// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "gl_objects.h"

#include "error.h"

namespace sample {
namespace {

/// Uploads go through a target that no draw looks at, so that they never change what is bound for drawing.
constexpr GLenum kUploadTarget = GL_COPY_WRITE_BUFFER;

GLuint compileShader(GLenum stage, const std::string& source) {
  const GLuint shader = glCreateShader(stage);
  const char* text = source.c_str();
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint compiled = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (compiled) return shader;
  char log[4096];
  glGetShaderInfoLog(shader, sizeof log, nullptr, log);
  throw Error(std::string("a shader does not compile: ") + log);
}

void requireComplete(const char* what) {
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw Error(std::string(what) + ": this OpenGL cannot draw to it");
  }
}

void addRenderbuffer(GLuint renderbuffer, GLenum attachment, GLenum format, int samples, int width, int height) {
  glBindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, renderbuffer);
}

}  // namespace

Buffer::Buffer(size_t bytes) : bytes_(bytes) {
  glGenBuffers(1, &id_);
  glBindBuffer(kUploadTarget, id_);
  glBufferData(kUploadTarget, static_cast<GLsizeiptr>(bytes), nullptr, GL_DYNAMIC_DRAW);
}

Buffer::~Buffer() { glDeleteBuffers(1, &id_); }

void Buffer::writeBytes(const void* data, size_t bytes) {
  if (bytes > bytes_) throw Error("a buffer is too small for what is written to it");
  glBindBuffer(kUploadTarget, id_);
  glBufferSubData(kUploadTarget, 0, static_cast<GLsizeiptr>(bytes), data);
}

void* Buffer::mapUnread(size_t offset, size_t bytes) {
  glBindBuffer(kUploadTarget, id_);
  void* memory = glMapBufferRange(kUploadTarget, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes),
                                  GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_RANGE_BIT | GL_MAP_UNSYNCHRONIZED_BIT);
  if (!memory) throw Error("a buffer cannot be mapped");
  return memory;
}

void Buffer::unmap() {
  glBindBuffer(kUploadTarget, id_);
  if (!glUnmapBuffer(kUploadTarget)) throw Error("a buffer lost its contents while it was mapped");
}

Program::Program(const std::string& vertex_source, const std::string& fragment_source) : id_(glCreateProgram()) {
  const GLuint vertex = compileShader(GL_VERTEX_SHADER, vertex_source);
  const GLuint fragment = compileShader(GL_FRAGMENT_SHADER, fragment_source);
  glAttachShader(id_, vertex);
  glAttachShader(id_, fragment);
  glLinkProgram(id_);
  glDeleteShader(vertex);
  glDeleteShader(fragment);
  GLint linked = 0;
  glGetProgramiv(id_, GL_LINK_STATUS, &linked);
  if (linked) return;
  char log[4096];
  glGetProgramInfoLog(id_, sizeof log, nullptr, log);
  throw Error(std::string("a shader program does not link: ") + log);
}

Program::~Program() { glDeleteProgram(id_); }

void Program::use() const { glUseProgram(id_); }

Target::Target(int width, int height, int samples) : width_(width), height_(height) {
  glGenFramebuffers(2, framebuffers_);
  glGenRenderbuffers(3, renderbuffers_);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffers_[0]);
  addRenderbuffer(renderbuffers_[0], GL_COLOR_ATTACHMENT0, GL_RGBA8, samples, width, height);
  addRenderbuffer(renderbuffers_[1], GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT32F, samples, width, height);
  requireComplete("a multisampled picture");
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffers_[1]);
  addRenderbuffer(renderbuffers_[2], GL_COLOR_ATTACHMENT0, GL_RGBA8, 0, width, height);
  requireComplete("a picture");
}

Target::~Target() {
  glDeleteFramebuffers(2, framebuffers_);
  glDeleteRenderbuffers(3, renderbuffers_);
}

void Target::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffers_[0]);
  glViewport(0, 0, width_, height_);
}

void Target::resolve() const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffers_[0]);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffers_[1]);
  glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffers_[1]);
}

void Target::show() const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffers_[1]);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

Picture Target::read() const {
  Picture picture(width_, height_);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffers_[1]);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width_, height_, GL_RGB, GL_UNSIGNED_BYTE, picture.rgb.data());
  picture.flipRows();  // OpenGL's first row is the lowest
  checkGl("reading the picture");
  return picture;
}

ShadowMap::ShadowMap(int size) : size_(size) {
  glGenTextures(1, &texture_);
  glBindTexture(GL_TEXTURE_2D, texture_);
  glTexStorage2D(GL_TEXTURE_2D, 1, GL_DEPTH_COMPONENT24, size, size);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glGenFramebuffers(1, &framebuffer_);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, texture_, 0);
  glDrawBuffer(GL_NONE);
  glReadBuffer(GL_NONE);
  requireComplete("a shadow map");
}

ShadowMap::~ShadowMap() {
  glDeleteFramebuffers(1, &framebuffer_);
  glDeleteTextures(1, &texture_);
}

void ShadowMap::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glViewport(0, 0, size_, size_);
  glClear(GL_DEPTH_BUFFER_BIT);
}

void ShadowMap::bindTexture(GLuint unit) const {
  glActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(GL_TEXTURE_2D, texture_);
}

void checkGl(const std::string& where) {
  const GLenum error = glGetError();
  if (error != GL_NO_ERROR) throw Error("OpenGL error " + std::to_string(error) + " at " + where);
}

}  // namespace sample
