#pragma once

#include <epoxy/gl.h>

namespace offing::present {

/// What a pass that lays something over a picture adds to it.
enum class LayerLight {
  drawn,
  left_out,  ///< nothing: it only hides what lies behind
};

/// For premultiplied light over the bound target.
inline void set_layer_blending(LayerLight light) {
  glBlendFunc(light == LayerLight::drawn ? GL_ONE : GL_ZERO, GL_ONE_MINUS_SRC_ALPHA);
}

}  // namespace offing::present
