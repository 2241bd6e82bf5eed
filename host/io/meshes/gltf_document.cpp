#include "host/io/meshes/gltf_document.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/io/file_extension.h"
#include "host/io/meshes/text_lines.h"
#include "host/io/percent_code.h"
#include "host/io/whole_file.h"

namespace offing::meshes {
namespace {

/// The bytes of "data:...;base64,..." (RFC 2397, RFC 4648); nothing for any other.
std::optional<std::string> decode_data_uri(std::string_view uri) {
  constexpr std::string_view mark = ";base64,";
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::size_t begin = uri.find(mark);
  if (!uri.starts_with("data:") || begin == std::string_view::npos) return std::nullopt;
  uri.remove_prefix(begin + mark.size());
  while (uri.ends_with('=')) uri.remove_suffix(1);
  std::string bytes;
  bytes.reserve(uri.size() / 4 * 3 + 3);
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : uri) {
    const std::size_t digit = digits.find(c);
    if (digit == std::string_view::npos) return std::nullopt;
    bits = (bits << 6) | static_cast<std::uint32_t>(digit);
    count += 6;
    if (count >= 8) {
      count -= 8;
      bytes += static_cast<char>((bits >> count) & 0xff);
    }
  }
  return bytes;
}

using nlohmann::json;

constexpr std::size_t most_bytes = std::size_t{1} << 36;

std::uint32_t word_at(std::string_view bytes, std::size_t at) {
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data() + at, sizeof(word));
  return word;
}

template <typename Number>
double number_at(const char* at, bool is_normalised) {
  Number number;
  std::memcpy(&number, at, sizeof(number));
  if constexpr (std::numeric_limits<Number>::is_integer) {
    // glTF 2.0, 3.11: the most negative number is as far as the one after it.
    if (is_normalised)
      return std::max(static_cast<double>(number) / std::numeric_limits<Number>::max(), -1.0);
  }
  return static_cast<double>(number);
}

// Component types of glTF 2.0, 3.6.2.2.
constexpr std::size_t signed_byte = 5120, unsigned_byte = 5121, signed_short = 5122, unsigned_short = 5123,
                      unsigned_int = 5125, real = 5126;

std::size_t bytes_of(std::size_t component_type) {
  switch (component_type) {
    case signed_byte:
    case unsigned_byte:
      return 1;
    case signed_short:
    case unsigned_short:
      return 2;
    case unsigned_int:
    case real:
      return 4;
    default:
      return 0;
  }
}

double component_at(const char* at, std::size_t component_type, bool is_normalised) {
  switch (component_type) {
    case signed_byte:
      return number_at<std::int8_t>(at, is_normalised);
    case unsigned_byte:
      return number_at<std::uint8_t>(at, is_normalised);
    case signed_short:
      return number_at<std::int16_t>(at, is_normalised);
    case unsigned_short:
      return number_at<std::uint16_t>(at, is_normalised);
    case unsigned_int:
      return number_at<std::uint32_t>(at, is_normalised);
    default:
      return number_at<float>(at, is_normalised);
  }
}

/// Elements of `width` numbers, one every `stride` bytes.
void append(std::string_view bytes, std::size_t count, std::size_t width, std::size_t stride,
            std::size_t component_type, bool is_normalised, std::vector<double>& values) {
  const std::size_t step = bytes_of(component_type);
  for (std::size_t i = 0; i < count; ++i) {
    const char* const at = bytes.data() + i * stride;
    for (std::size_t k = 0; k < width; ++k)
      values.push_back(component_at(at + k * step, component_type, is_normalised));
  }
}

constexpr std::size_t header_bytes = 12, chunk_header_bytes = 8;  // of a .glb
constexpr std::uint32_t json_type = 0x4e4f534a, binary_type = 0x004e4942;

/// The JSON of a file that is a glTF, without its buffers; "" where there is none.
std::string json_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string header(header_bytes, '\0');
  file.read(header.data(), header_bytes);
  if (!is_gltf(header, path)) return "";
  std::error_code status;
  const std::uintmax_t size = std::filesystem::file_size(path, status);
  if (status || size > most_bytes) return "";
  std::size_t begin = 0, length = size;
  if (is_binary_gltf(header)) {
    std::string chunk(chunk_header_bytes, '\0');
    begin = header_bytes;
    length = 0;
    do {
      begin += length;
      if (!file.seekg(static_cast<std::streamoff>(begin)).read(chunk.data(), chunk_header_bytes)) return "";
      begin += chunk_header_bytes;
      length = word_at(chunk, 0);
    } while (word_at(chunk, 4) != json_type);
    if (length > size - begin) return "";
  }
  std::string text(length, '\0');
  file.clear();
  file.seekg(static_cast<std::streamoff>(begin)).read(text.data(), static_cast<std::streamsize>(length));
  return file ? text : "";
}

}  // namespace

bool is_binary_gltf(std::string_view bytes) {
  return bytes.starts_with("glTF");
}

bool is_gltf(std::string_view bytes, const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  return is_binary_gltf(bytes) || extension == ".gltf" || extension == ".glb";
}

std::string shown(const json& value) {
  // Lists may be nested so deep that printing them ends the stack.
  return value.is_string()      ? printable(value.get<std::string>())
         : value.is_primitive() ? value.dump()
                                : value.type_name();
}

GltfDocument::GltfDocument(std::string_view bytes, const std::filesystem::path& path, Trust trust)
    : path_(path), trust_(trust), bytes_(bytes.size()) {
  const std::string_view text = parse_container(bytes);
  root_ = json::parse(text, nullptr, false);
  if (root_.is_discarded() || !root_.is_object()) fail("glTF: an object in JSON", "something else");
  const auto asset = root_.find("asset");
  if (asset == root_.end() || !asset->is_object() || asset->value("version", json()) != "2.0") {
    fail("glTF with asset.version 2.0", "another");
  }
  load_buffers();
}

/// The JSON of a .gltf, which it is, or of a .glb: 12 bytes of header, then chunks of a length, a type and
/// data.
std::string_view GltfDocument::parse_container(std::string_view bytes) {
  if (!is_binary_gltf(bytes)) return bytes;
  is_binary_ = true;
  if (bytes.size() < header_bytes + chunk_header_bytes) fail("the header of a .glb", "the end of the file");
  if (word_at(bytes, 4) != 2) fail("a .glb of version 2", fmt::format("version {}", word_at(bytes, 4)));
  const std::size_t length = word_at(bytes, 8);
  if (length > bytes.size()) {
    fail(fmt::format("{} bytes", length), fmt::format("a file of {}", bytes.size()));
  }
  bytes_over_ = bytes.size() - length;
  std::string_view rest = bytes.substr(0, length), text;
  rest.remove_prefix(std::min(header_bytes, rest.size()));
  while (!rest.empty()) {
    if (rest.size() < chunk_header_bytes || rest.size() - chunk_header_bytes < word_at(rest, 0)) {
      fail("whole chunks in a .glb", "a chunk that ends early");
    }
    const std::uint32_t type = word_at(rest, 4);
    const std::string_view data = rest.substr(chunk_header_bytes, word_at(rest, 0));
    rest.remove_prefix(chunk_header_bytes + data.size());
    if (type == json_type && text.empty()) text = data;
    if (type == binary_type && binary_chunk_.empty()) binary_chunk_ = data;
  }
  return text;
}

void GltfDocument::load_buffers() {
  const std::size_t buffer_count = count("buffers");
  own_buffers_.reserve(buffer_count);  // views into them must stay
  for (std::size_t i = 0; i < buffer_count; ++i) {
    const json& buffer = object("buffers", i);
    const std::size_t length = whole(buffer, "byteLength", std::nullopt);
    std::string_view data = binary_chunk_;
    if (const auto uri = buffer.find("uri"); uri != buffer.end()) {
      if (!uri->is_string()) fail("a string as the URI of a buffer", uri->type_name());
      own_buffers_.push_back(load_buffer(uri->get<std::string>()));
      data = own_buffers_.back();
      bytes_ += data.size();
    } else if (i != 0 || !is_binary_) {
      fail("a URI for each buffer but the first of a .glb", fmt::format("none of buffer {}", i));
    }
    if (length > data.size()) {
      fail(fmt::format("{} bytes in buffer {}", length, i), fmt::format("{}", data.size()));
    }
    buffers_.push_back(data.substr(0, length));
  }
}

std::string GltfDocument::load_buffer(const std::string& uri) const {
  if (uri.starts_with("data:")) {
    if (std::optional<std::string> data = decode_data_uri(uri)) return std::move(*data);
    fail("a data URI in base64", '"' + printable(uri) + '"');
  }
  const std::string name = decode_percent(uri);
  const bool is_relative = uri.find("://") == std::string::npos && std::filesystem::path(name).is_relative();
  if (!is_relative) fail("buffers in files beside the glTF", '"' + printable(uri) + '"');
  require_beside(path_, path_.parent_path() / name, trust_);
  return read_whole_file(path_.parent_path() / name,
                         {.kind = "a buffer of a glTF", .most_bytes = most_bytes});
}

const json& GltfDocument::object(const char* list, std::size_t index) const {
  const auto found = root_.find(list);
  if (found == root_.end() || !found->is_array() || index >= found->size() || !(*found)[index].is_object()) {
    fail(fmt::format("an object {}[{}]", list, index), "none");
  }
  return (*found)[index];
}

std::size_t GltfDocument::count(const char* list) const {
  const auto found = root_.find(list);
  if (found == root_.end()) return 0;
  if (!found->is_array()) fail(fmt::format("a list {}", list), found->type_name());
  return found->size();
}

std::size_t GltfDocument::whole(const json& object, const char* key,
                                std::optional<std::size_t> otherwise) const {
  const auto found = object.find(key);
  if (found == object.end() && otherwise) return *otherwise;
  if (found == object.end() || !found->is_number_unsigned()) {
    fail(fmt::format("a whole number {}", key), found == object.end() ? "none" : shown(*found));
  }
  return found->get<std::size_t>();
}

std::vector<double> GltfDocument::numbers(const json& object, const char* key, std::size_t count) const {
  const auto found = object.find(key);
  std::vector<double> numbers;
  if (found == object.end()) return numbers;
  if (!found->is_array() || found->size() != count)
    fail(fmt::format("{} numbers in {}", count, key), "others");
  for (const json& number : *found) {
    if (!number.is_number() || !std::isfinite(number.get<double>())) {
      fail(fmt::format("{} numbers in {}", count, key), shown(number));
    }
    numbers.push_back(number.get<double>());
  }
  return numbers;
}

std::size_t GltfDocument::element_count(std::size_t accessor) const {
  return whole(object("accessors", accessor), "count", std::nullopt);
}

/// Elements where an object says: of an accessor, or of the indices or values of a sparse one.
GltfDocument::View GltfDocument::view_of(std::string_view name, const json& where, std::size_t count,
                                         std::size_t component_type, std::size_t width) const {
  const std::size_t element_bytes = width * bytes_of(component_type);
  if (element_bytes == 0) fail(fmt::format("a component type of {} that glTF knows", name), "another");
  const json& buffer_view = object("bufferViews", whole(where, "bufferView", std::nullopt));
  const std::size_t buffer = whole(buffer_view, "buffer", std::nullopt);
  if (buffer >= buffers_.size())
    fail(fmt::format("buffers[{}]", buffer), fmt::format("{} buffers", buffers_.size()));
  View view{.bytes = buffers_[buffer], .count = count, .stride = 0, .component_type = component_type};
  for (const std::size_t offset : {whole(buffer_view, "byteOffset", 0), whole(where, "byteOffset", 0)}) {
    if (offset > view.bytes.size())
      fail(fmt::format("the start of {} within its buffer", name), "a start beyond it");
    view.bytes.remove_prefix(offset);
  }
  view.stride = whole(buffer_view, "byteStride", element_bytes);
  if (view.stride < element_bytes || view.stride > 252)
    fail(fmt::format("a stride of {} to 252 bytes", element_bytes), fmt::format("{}", view.stride));
  const std::size_t room =
      view.bytes.size() < element_bytes ? 0 : (view.bytes.size() - element_bytes) / view.stride + 1;
  if (view.count > room) {
    fail(fmt::format("{} elements of {}", view.count, name), fmt::format("a buffer with room for {}", room));
  }
  return view;
}

std::vector<double> GltfDocument::components(std::size_t accessor, std::string_view type,
                                             std::size_t width) const {
  const json& object_of = object("accessors", accessor);
  const std::string name = fmt::format("accessors[{}]", accessor);
  if (object_of.value("type", json()) != type) fail(fmt::format("{} of type {}", name, type), "another");
  const std::size_t count = element_count(accessor);
  std::vector<double> values;
  if (object_of.contains("bufferView")) {
    const View view = view_of(name, object_of, count, whole(object_of, "componentType", std::nullopt), width);
    const bool is_normalised = object_of.value("normalized", json()) == true;
    values.reserve(count * width);
    append(view.bytes, count, width, view.stride, view.component_type, is_normalised, values);
  } else {
    // What moves vertices that are in the file, so that there are no more of these than bytes.
    if (count > bytes_)
      fail(fmt::format("at most {} elements of {}", bytes_, name), fmt::format("{}", count));
    values.assign(count * width, 0.0);
  }
  if (object_of.contains("sparse")) fill_sparse(name, object_of, width, values);
  return values;
}

void GltfDocument::fill_sparse(std::string_view name, const json& accessor, std::size_t width,
                               std::vector<double>& values) const {
  const json& sparse = accessor["sparse"];
  const auto part = [&](const char* key) -> const json& {
    if (!sparse.is_object() || !sparse.contains(key) || !sparse[key].is_object())
      fail(fmt::format("an object {} of the sparse {}", key, name), "none");
    return sparse[key];
  };
  const json &where = part("indices"), &what = part("values");
  const std::size_t count = whole(sparse, "count", std::nullopt);
  const View at = view_of(name, where, count, whole(where, "componentType", std::nullopt), 1);
  const View replaced = view_of(name, what, count, whole(accessor, "componentType", std::nullopt), width);
  std::vector<double> places, numbers;
  append(at.bytes, count, 1, at.stride, at.component_type, false, places);
  append(replaced.bytes, count, width, replaced.stride, replaced.component_type,
         accessor.value("normalized", json()) == true, numbers);
  const std::size_t elements = values.size() / width;
  for (std::size_t i = 0; i < count; ++i) {
    if (!(places[i] >= 0.0 && places[i] < static_cast<double>(elements)))
      fail(fmt::format("indices below {} in the sparse {}", elements, name), fmt::format("{}", places[i]));
    const auto first = static_cast<std::ptrdiff_t>(static_cast<std::size_t>(places[i]) * width);
    std::copy_n(numbers.begin() + static_cast<std::ptrdiff_t>(i * width), width, values.begin() + first);
  }
}

std::vector<glm::dvec3> GltfDocument::vectors(std::size_t accessor) const {
  const std::vector<double> values = components(accessor, "VEC3", 3);
  std::vector<glm::dvec3> vectors(values.size() / 3);
  for (std::size_t i = 0; i < vectors.size(); ++i)
    vectors[i] = {values[3 * i], values[3 * i + 1], values[3 * i + 2]};
  return vectors;
}

std::vector<std::uint32_t> GltfDocument::indices(std::size_t accessor) const {
  const std::size_t type = whole(object("accessors", accessor), "componentType", std::nullopt);
  if (type != unsigned_byte && type != unsigned_short && type != unsigned_int)
    fail("unsigned indices", fmt::format("component type {}", type));
  std::vector<std::uint32_t> indices;
  for (const double value : components(accessor, "SCALAR", 1))
    indices.push_back(static_cast<std::uint32_t>(value));
  return indices;
}

void GltfDocument::fail(std::string_view expected, std::string_view got, const char* hint) const {
  const Error error = mesh_error(path_.string(), 0, expected, got);
  if (hint == nullptr) throw error;
  throw Error(error.kind(), error.what(), hint);
}

std::vector<std::filesystem::path> files_of_gltf(const std::filesystem::path& path) {
  const json root = json::parse(json_of(path), nullptr, false);
  std::vector<std::filesystem::path> files;
  for (const char* list : {"buffers", "images"}) {
    if (!root.is_object() || !root.contains(list)) continue;
    for (const json& object : root[list]) {
      const json uri = object.is_object() ? object.value("uri", json()) : json();
      if (!uri.is_string() || uri.get_ref<const std::string&>().starts_with("data:")) continue;
      files.push_back(path.parent_path() / decode_percent(uri.get<std::string>()));
    }
  }
  return files;
}

}  // namespace offing::meshes
