#pragma once

#include <utility>

#include <epoxy/gl.h>

namespace offing::present {

/// Owns one OpenGL object; `Kind` says how it is made and deleted. 0 is none.
template <class Kind>
class GlObject {
 public:
  GlObject() = default;
  /// Makes a new object.
  static GlObject make() {
    GlObject object;
    Kind::generate(object.name_);
    return object;
  }
  GlObject(GlObject&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  GlObject& operator=(GlObject&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  GlObject(const GlObject&) = delete;
  GlObject& operator=(const GlObject&) = delete;
  ~GlObject() {
    if (name_ != 0) Kind::remove(name_);
  }

  GLuint name() const { return name_; }
  explicit operator bool() const { return name_ != 0; }

 private:
  GLuint name_ = 0;
};

namespace detail {
struct TextureKind {
  static void generate(GLuint& name) { glGenTextures(1, &name); }
  static void remove(GLuint name) { glDeleteTextures(1, &name); }
};
struct BufferKind {
  static void generate(GLuint& name) { glGenBuffers(1, &name); }
  static void remove(GLuint name) { glDeleteBuffers(1, &name); }
};
struct FramebufferKind {
  static void generate(GLuint& name) { glGenFramebuffers(1, &name); }
  static void remove(GLuint name) { glDeleteFramebuffers(1, &name); }
};
struct VertexArrayKind {
  static void generate(GLuint& name) { glGenVertexArrays(1, &name); }
  static void remove(GLuint name) { glDeleteVertexArrays(1, &name); }
};
struct QueryKind {
  static void generate(GLuint& name) { glGenQueries(1, &name); }
  static void remove(GLuint name) { glDeleteQueries(1, &name); }
};
}  // namespace detail

using GlTexture = GlObject<detail::TextureKind>;
using GlBuffer = GlObject<detail::BufferKind>;
using GlFramebuffer = GlObject<detail::FramebufferKind>;
using GlVertexArray = GlObject<detail::VertexArrayKind>;
using GlQuery = GlObject<detail::QueryKind>;

}  // namespace offing::present
