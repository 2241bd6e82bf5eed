#pragma once

#include "present/gl/render_target.h"

namespace offing::present {

/// Copies a picture to the window of the current context, of so many pixels, enlarged where it is smaller;
/// the window's framebuffer and viewport are set from here on.
void copy_to_window(const RenderTarget& picture, int width, int height);

}  // namespace offing::present
