#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

namespace offing::animations {

/// The one buffer of a glTF file with the views and accessors into it (glTF 2.0, section 3.6).
class GltfBuffer {
 public:
  /// Rows of `components` (1, 3 or 4) floats; the index of their accessor. With the least and largest of each
  /// component, which glTF wants of positions and of key times.
  std::size_t add(std::span<const float> values, std::size_t components);
  /// Indices of triangles' corners.
  std::size_t add_indices(std::span<const std::uint16_t> indices);
  /// Any bytes, as a view without an accessor: its index.
  std::size_t add_bytes(std::string_view bytes);

  const std::string& bytes() const { return bytes_; }
  const nlohmann::ordered_json& views() const { return views_; }
  const nlohmann::ordered_json& accessors() const { return accessors_; }

 private:
  std::string bytes_;
  nlohmann::ordered_json views_ = nlohmann::ordered_json::array();
  nlohmann::ordered_json accessors_ = nlohmann::ordered_json::array();
};

}  // namespace offing::animations
