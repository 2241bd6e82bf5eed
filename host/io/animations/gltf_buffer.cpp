#include "host/io/animations/gltf_buffer.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace offing::animations {
namespace {

// As glTF numbers them.
constexpr int float_type = 5126, uint16_type = 5123;

static_assert(std::endian::native == std::endian::little, "glTF's buffers are little-endian");

template <typename T>
std::string_view bytes_of(std::span<const T> values) {
  return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

}  // namespace

std::size_t GltfBuffer::add_bytes(std::string_view bytes) {
  bytes_.resize((bytes_.size() + 3) / 4 * 4, '\0');  // numbers lie at multiples of their size
  views_.push_back({{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", bytes.size()}});
  bytes_ += bytes;
  return views_.size() - 1;
}

std::size_t GltfBuffer::add(std::span<const float> values, std::size_t components) {
  nlohmann::ordered_json least = nlohmann::ordered_json::array(), largest = least;
  for (std::size_t c = 0; c < components; ++c) {
    float low = values[c], high = values[c];
    for (std::size_t i = c; i < values.size(); i += components) {
      low = std::min(low, values[i]);
      high = std::max(high, values[i]);
    }
    least.push_back(low);
    largest.push_back(high);
  }
  const char* type = components == 1   ? "SCALAR"
                     : components == 3 ? "VEC3"
                     : components == 2 ? "VEC2"
                                       : "VEC4";
  accessors_.push_back({{"bufferView", add_bytes(bytes_of(values))},
                        {"componentType", float_type},
                        {"count", values.size() / components},
                        {"type", type},
                        {"min", std::move(least)},
                        {"max", std::move(largest)}});
  return accessors_.size() - 1;
}

std::size_t GltfBuffer::add_indices(std::span<const std::uint16_t> indices) {
  accessors_.push_back({{"bufferView", add_bytes(bytes_of(indices))},
                        {"componentType", uint16_type},
                        {"count", indices.size()},
                        {"type", "SCALAR"}});
  return accessors_.size() - 1;
}

}  // namespace offing::animations
