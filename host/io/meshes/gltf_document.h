#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

#include "host/io/file_trust.h"

namespace offing::meshes {

/// A value of a document as an error shows it.
std::string shown(const nlohmann::json& value);

/// A glTF 2.0 document with its buffers: what it refers to is checked when it is asked for.
class GltfDocument {
 public:
  /// Of a .gltf or a .glb; buffers beside the file are read. Throws Error(bad_input) for what is neither, and
  /// as require_beside() for buffers.
  GltfDocument(std::string_view bytes, const std::filesystem::path& path, Trust trust);

  /// Object `index` of a list at the document's top, such as "nodes". Throws Error(bad_input) if there is
  /// none.
  const nlohmann::json& object(const char* list, std::size_t index) const;
  /// How many the list has; 0 if there is none.
  std::size_t count(const char* list) const;

  /// A whole number from 0 on of an object; `otherwise` if it is not there. Throws Error(bad_input) if it is
  /// none, or if it is needed.
  std::size_t whole(const nlohmann::json& object, const char* key,
                    std::optional<std::size_t> otherwise) const;
  /// `count` finite numbers, or nothing if there are none.
  std::vector<double> numbers(const nlohmann::json& object, const char* key, std::size_t count) const;

  /// How many elements an accessor has, as the document says it.
  std::size_t element_count(std::size_t accessor) const;
  /// The numbers of an accessor of a type such as "MAT4", `width` an element; vectors of one of
  /// "VEC3"; whole numbers. Normalised integers are divided by their largest value. Elements that a sparse
  /// accessor leaves out are 0.
  std::vector<double> components(std::size_t accessor, std::string_view type, std::size_t width) const;
  std::vector<glm::dvec3> vectors(std::size_t accessor) const;
  std::vector<std::uint32_t> indices(std::size_t accessor) const;

  const nlohmann::json& root() const { return root_; }
  std::size_t bytes() const { return bytes_; }            ///< of the file and its buffers
  std::size_t bytes_over() const { return bytes_over_; }  ///< after the end of a .glb
  bool is_binary() const { return is_binary_; }

  /// Throws Error(bad_input), with the hint that the file is damaged or another one.
  [[noreturn]] void fail(std::string_view expected, std::string_view got, const char* hint = nullptr) const;

 private:
  /// Elements in a buffer.
  struct View {
    std::string_view bytes;  ///< from the first element on
    std::size_t count, stride, component_type;
  };

  std::string_view parse_container(std::string_view bytes);
  void load_buffers();
  std::string load_buffer(const std::string& uri) const;
  View view_of(std::string_view name, const nlohmann::json& where, std::size_t count,
               std::size_t component_type, std::size_t width) const;
  void fill_sparse(std::string_view name, const nlohmann::json& accessor, std::size_t width,
                   std::vector<double>& values) const;

  std::filesystem::path path_;
  Trust trust_;
  nlohmann::json root_;
  std::string_view binary_chunk_;
  std::vector<std::string> own_buffers_;
  std::vector<std::string_view> buffers_;
  std::size_t bytes_ = 0, bytes_over_ = 0;
  bool is_binary_ = false;
};

/// Whether the first bytes of a file, or its name, are those of a glTF; whether the bytes are those of a
/// .glb.
bool is_gltf(std::string_view bytes, const std::filesystem::path& path);
bool is_binary_gltf(std::string_view bytes);

/// The buffers and images that a .gltf or .glb names beside itself, there or not. Reads its JSON alone; empty
/// for a file that is none or damaged.
std::vector<std::filesystem::path> files_of_gltf(const std::filesystem::path& path);

}  // namespace offing::meshes
