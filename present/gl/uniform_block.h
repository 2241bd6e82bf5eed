#pragma once

#include <array>
#include <cstddef>
#include <cstring>
#include <span>
#include <type_traits>

#include "present/gl/gl_objects.h"
#include "present/gl/shader_program.h"

namespace offing::present {

/// The buffer of a uniform block.
class UniformBuffer {
 public:
  /// `name` is the block's. No other block of a program may have the same `binding`.
  UniformBuffer(const char* name, GLuint binding);

  /// Gives the values of the last fill() to a program in use.
  void bind(const ShaderProgram& program) const;

 protected:
  void upload(std::span<const std::byte> bytes);

 private:
  const char* name_;
  GLuint binding_;
  std::size_t size_ = 0;
  GlBuffer buffer_;
};

/// The values of a uniform block, `layout(std140) uniform Name { A a; B b; };`, as structs that C++ and GLSL
/// read from the same file (glsl_types.h).
template <class... Parts>
class UniformBlock : public UniformBuffer {
  static_assert((std::is_trivially_copyable_v<Parts> && ...));

 public:
  using UniformBuffer::UniformBuffer;

  void fill(const Parts&... parts) {
    std::array<std::byte, (padded(sizeof(Parts)) + ...)> bytes{};
    std::size_t at = 0;
    ((std::memcpy(bytes.data() + at, &parts, sizeof(Parts)), at += padded(sizeof(Parts))), ...);
    upload(bytes);
  }

 private:
  // std140 begins and ends structs at multiples of 16 bytes.
  static constexpr std::size_t padded(std::size_t bytes) { return (bytes + 15) / 16 * 16; }
};

}  // namespace offing::present
