#pragma once

#include <epoxy/gl.h>

namespace offing::present {

/// Binding points of uniform blocks. A program has at most one block at each.
enum UniformBinding : GLuint {
  pass_binding,  ///< the values of a pass, or of one thing that it draws
  sky_binding,
  cloud_shadow_binding,
  rings_binding,
  shoals_binding,
  lights_binding,
};

}  // namespace offing::present
