#pragma once

#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "host/base/rgba_image.h"
#include "host/highlights/highlight_rule.h"
#include "present/gl_objects.h"

namespace offing::present {

/// OpenGL's copies of the pictures that highlights show, with mip levels, premultiplied: colours linear,
/// normals as they are.
class HighlightPictures {
 public:
  using Pictures = std::vector<std::shared_ptr<const RgbaImage>>;

  HighlightPictures();

  /// The texture for these controls, which is made when it is first asked for; a white one for shapes, and
  /// where there is no such picture.
  GLuint texture(const Pictures& pictures, const highlights::HighlightControls& controls);

 private:
  enum class Use { colours, normals };
  static GlTexture uploaded(const RgbaImage& picture, Use use);

  GlTexture white_;
  // Pictures are held, so that no other one can come to the place of one that is gone.
  std::map<std::pair<std::shared_ptr<const RgbaImage>, Use>, GlTexture> textures_;
};

}  // namespace offing::present
