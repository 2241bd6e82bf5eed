#pragma once

#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "host/base/rgba_image.h"
#include "present/gl/gl_objects.h"

namespace offing::present {

/// What a picture is for: colours with alpha and normals, nothing beyond their edges; ramps of light, which
/// go on beyond them.
enum class ImageUse { colours, normals, ramp };

/// OpenGL's copies of the pictures of a world, with mip levels, premultiplied: colours and ramps linear,
/// normals as they are.
class ImageTextures {
 public:
  using Images = std::vector<std::shared_ptr<const RgbaImage>>;

  ImageTextures();

  /// The texture of a picture by its index, which is made when it is first asked for; a white one where there
  /// is no such picture. Copies of pictures that are not in the list any more go when one is made.
  GLuint texture(const Images& pictures, int index, ImageUse use);

 private:
  static GlTexture uploaded(const RgbaImage& picture, ImageUse use);

  GlTexture white_;
  // Pictures are held, so that no other one can come to the place of one that is gone.
  std::map<std::pair<std::shared_ptr<const RgbaImage>, ImageUse>, GlTexture> textures_;
};

}  // namespace offing::present
