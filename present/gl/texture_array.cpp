#include "present/gl/texture_array.h"

#include <algorithm>
#include <bit>

namespace offing::present {

TextureArray::TextureArray(const Shape& shape, int levels) : shape_(shape), texture_(GlTexture::make()) {
  glBindTexture(GL_TEXTURE_2D_ARRAY, texture_.name());
  const GLint format = shape.channels == 1 ? GL_R32F : GL_RGBA32F;
  for (int level = 0; level < levels; ++level) {
    glTexImage3D(GL_TEXTURE_2D_ARRAY, level, format, std::max(1, shape.width >> level),
                 std::max(1, shape.height >> level), shape.layers, 0, shape.channels == 1 ? GL_RED : GL_RGBA,
                 GL_FLOAT, nullptr);
  }
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, levels - 1);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

std::size_t TextureArray::count() const {
  return static_cast<std::size_t>(shape_.width) * static_cast<std::size_t>(shape_.height) *
         static_cast<std::size_t>(shape_.layers) * static_cast<std::size_t>(shape_.channels);
}

void TextureArray::specify(const void* texels) const {
  glBindTexture(GL_TEXTURE_2D_ARRAY, texture_.name());
  glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, 0, shape_.width, shape_.height, shape_.layers,
                  shape_.channels == 1 ? GL_RED : GL_RGBA, GL_FLOAT, texels);
}

void TextureArray::bind(int unit) const {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(GL_TEXTURE_2D_ARRAY, texture_.name());
}

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
