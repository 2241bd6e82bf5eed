#include "present/map_texture.h"

#include <algorithm>

namespace offing::present {

MapTexture::MapTexture(int size, int layers, int channels)
    : size_(size), layers_(layers), channels_(channels), texture_(GlTexture::make()) {
  glBindTexture(GL_TEXTURE_2D_ARRAY, texture_.name());
  const GLint format = channels == 1 ? GL_R32F : GL_RGBA32F;
  int level = 0;
  for (int width = size; width >= 1; width /= 2, ++level) {
    glTexImage3D(GL_TEXTURE_2D_ARRAY, level, format, width, width, layers, 0,
                 channels == 1 ? GL_RED : GL_RGBA, GL_FLOAT, nullptr);
  }
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, level - 1);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_S, GL_REPEAT);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_T, GL_REPEAT);
}

std::size_t MapTexture::count() const {
  const auto side = static_cast<std::size_t>(size_);
  return side * side * static_cast<std::size_t>(layers_) * static_cast<std::size_t>(channels_);
}

void MapTexture::specify(const void* texels) const {
  glBindTexture(GL_TEXTURE_2D_ARRAY, texture_.name());
  glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, 0, size_, size_, layers_, channels_ == 1 ? GL_RED : GL_RGBA,
                  GL_FLOAT, texels);
}

void MapTexture::make_levels() const {
  glBindTexture(GL_TEXTURE_2D_ARRAY, texture_.name());
  glGenerateMipmap(GL_TEXTURE_2D_ARRAY);
}

void MapTexture::bind(int unit) const {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(GL_TEXTURE_2D_ARRAY, texture_.name());
}

}  // namespace offing::present
