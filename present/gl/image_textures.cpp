#include "present/gl/image_textures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace offing::present {
namespace {

float linear_of(std::uint8_t srgb) {
  const float value = static_cast<float>(srgb) / 255.0f;
  return value <= 0.04045f ? value / 12.92f : std::pow((value + 0.055f) / 1.055f, 2.4f);
}

float plain_of(std::uint8_t byte) {
  return static_cast<float>(byte) / 255.0f;
}

/// Rows as they are: the first one is the top of the box (highlight.frag).
std::vector<float> premultiplied(const RgbaImage& picture, float (*value_of)(std::uint8_t)) {
  std::vector<float> texels(picture.rgba.size());
  for (std::size_t i = 0; i < texels.size(); i += 4) {
    const float alpha = plain_of(picture.rgba[i + 3]);
    for (std::size_t c = 0; c < 3; ++c) texels[i + c] = alpha * value_of(picture.rgba[i + c]);
    texels[i + 3] = alpha;
  }
  return texels;
}

}  // namespace

ImageTextures::ImageTextures()
    : white_(uploaded({.width = 1, .height = 1, .rgba = {255, 255, 255, 255}}, ImageUse::normals)) {}

GlTexture ImageTextures::uploaded(const RgbaImage& picture, ImageUse use) {
  const std::vector<float> texels = premultiplied(picture, use == ImageUse::normals ? plain_of : linear_of);
  GlTexture texture = GlTexture::make();
  glBindTexture(GL_TEXTURE_2D, texture.name());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA16F, picture.width, picture.height, 0, GL_RGBA, GL_FLOAT,
               texels.data());
  glGenerateMipmap(GL_TEXTURE_2D);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  constexpr std::array<float, 4> clear{};
  glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, clear.data());
  const GLint beyond = use == ImageUse::ramp ? GL_CLAMP_TO_EDGE : GL_CLAMP_TO_BORDER;
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, beyond);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, beyond);
  return texture;
}

GLuint ImageTextures::texture(const Images& pictures, int index, ImageUse use) {
  const auto place = static_cast<std::size_t>(index);
  if (place >= pictures.size() || !pictures[place]) return white_.name();
  GlTexture& texture = textures_[{pictures[place], use}];
  if (texture) return texture.name();
  texture = uploaded(*pictures[place], use);
  std::erase_if(textures_, [&](const auto& kept) {
    return std::ranges::find(pictures, kept.first.first) == pictures.end();
  });
  return texture.name();
}

}  // namespace offing::present
