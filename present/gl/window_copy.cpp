#include "present/gl/window_copy.h"

#include <epoxy/gl.h>

namespace offing::present {

void copy_to_window(const RenderTarget& picture, int width, int height) {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, picture.framebuffer());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  glBlitFramebuffer(0, 0, picture.width(), picture.height(), 0, 0, width, height, GL_COLOR_BUFFER_BIT,
                    GL_LINEAR);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glViewport(0, 0, width, height);
}

}  // namespace offing::present
