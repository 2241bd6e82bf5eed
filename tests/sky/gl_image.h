#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace offing::test {

using GlTexel = std::array<float, 4>;

/// A picture that a fragment shader paints in single precision, in an OpenGL 3.3 core context without a
/// window (EGL, surfaceless).
class GlImage {
 public:
  /// Throws std::runtime_error that says what is missing where there is no such context.
  GlImage(int width, int height);
  ~GlImage();
  GlImage(const GlImage&) = delete;
  GlImage& operator=(const GlImage&) = delete;

  /// Driver and version.
  std::string renderer() const;

  /// A read-only array [rows][columns] as an RGBA32F texture.
  struct Table {
    std::string sampler;  ///< name of the uniform sampler2D
    int columns = 0;
    std::vector<GlTexel> texels;
  };

  /// Compiles `fragment` (with its #version line) and paints [height][width], row 0 at gl_FragCoord.y = 0.5.
  /// The bytes of `block` are its std140 uniform block `block_name`. Throws std::runtime_error with the
  /// compiler's log.
  std::vector<GlTexel> paint(const std::string& fragment, const std::string& block_name,
                             std::span<const std::byte> block, const std::vector<Table>& tables) const;

 private:
  struct Context;
  std::unique_ptr<Context> context_;
  int width_, height_;
};

}  // namespace offing::test
