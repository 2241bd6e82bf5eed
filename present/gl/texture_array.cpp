#include "present/gl/texture_array.h"

#include <algorithm>
#include <bit>
#include <vector>

namespace offing::present {
namespace {

/// Means of two by two texels: [layers][2 n][2 n][channels] become [layers][n][n][channels].
template <std::size_t channels>
void halve(std::span<const float> finer, std::size_t finer_size, std::vector<float>& coarser) {
  const std::size_t row = finer_size * channels;
  coarser.resize(finer.size() / 4);
  float* mean = coarser.data();
  for (const float* above = finer.data(); above != finer.data() + finer.size(); above += 2 * row) {
    for (std::size_t x = 0; x < row; x += 2 * channels) {
      for (std::size_t i = x; i < x + channels; ++i)
        *mean++ = 0.25f * (above[i] + above[i + channels] + above[row + i] + above[row + i + channels]);
    }
  }
}

}  // namespace

TextureArray::TextureArray(const Shape& shape, int levels)
    : shape_(shape), levels_(levels), texture_(GlTexture::make()) {
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

void TextureArray::specify_level(int level, const void* texels) const {
  glTexSubImage3D(GL_TEXTURE_2D_ARRAY, level, 0, 0, 0, std::max(1, shape_.width >> level),
                  std::max(1, shape_.height >> level), shape_.layers,
                  shape_.channels == 1 ? GL_RED : GL_RGBA, GL_FLOAT, texels);
}

void TextureArray::specify(const void* texels) const {
  glBindTexture(GL_TEXTURE_2D_ARRAY, texture_.name());
  specify_level(0, texels);
  if (levels_ > 1) glGenerateMipmap(GL_TEXTURE_2D_ARRAY);
}

void TextureArray::specify_levels(std::span<const float> texels) const {
  glBindTexture(GL_TEXTURE_2D_ARRAY, texture_.name());
  specify_level(0, texels.data());
  std::vector<float> finer, coarser;
  for (int level = 1; level < levels_; ++level) {
    const auto finer_size = static_cast<std::size_t>(shape_.width >> (level - 1));
    const auto halve_texels = shape_.channels == 1 ? halve<1> : halve<4>;
    halve_texels(level == 1 ? texels : finer, finer_size, coarser);
    specify_level(level, coarser.data());
    finer.swap(coarser);
  }
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

}  // namespace offing::present
