#include "present/gl/map_texture.h"

#include <bit>

namespace offing::present {

MapTexture::MapTexture(int size, int layers, int channels)
    : TextureArray({.width = size, .height = size, .layers = layers, .channels = channels},
                   std::bit_width(static_cast<unsigned>(size))) {
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_S, GL_REPEAT);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_T, GL_REPEAT);
}

void MapTexture::make_levels() const {
  glBindTexture(GL_TEXTURE_2D_ARRAY, name());
  glGenerateMipmap(GL_TEXTURE_2D_ARRAY);
}

}  // namespace offing::present
