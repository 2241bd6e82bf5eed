#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <nlohmann/json.hpp>

#include "host/io/animations/highlight_animation.h"
#include "host/io/percent_code.h"
#include "host/io/png_image.h"

namespace offing::animations {
namespace {

/// The one buffer of a glTF file with the views and accessors into it (glTF 2.0, section 3.6).
class GltfBuffer {
 public:
  /// Rows of `components` (1, 3 or 4) floats; the index of their accessor. With the least and largest of each
  /// component, which glTF wants of positions and of key times.
  std::size_t add(std::span<const float> values, std::size_t components);
  /// Indices of triangles' corners.
  std::size_t add_indices(std::span<const std::uint16_t> indices);
  std::size_t add_indices(std::span<const std::uint32_t> indices);
  /// Any bytes, as a view without an accessor: its index.
  std::size_t add_bytes(std::string_view bytes);

  const std::string& bytes() const { return bytes_; }
  const nlohmann::ordered_json& views() const { return views_; }
  const nlohmann::ordered_json& accessors() const { return accessors_; }

 private:
  std::size_t add_index_accessor(std::size_t view, std::size_t count, int type);

  std::string bytes_;
  nlohmann::ordered_json views_ = nlohmann::ordered_json::array();
  nlohmann::ordered_json accessors_ = nlohmann::ordered_json::array();
};

// As glTF numbers them.
constexpr int float_type = 5126, uint16_type = 5123, uint32_type = 5125;

static_assert(std::endian::native == std::endian::little, "glTF's buffers are little-endian");

template <typename T>
std::string_view bytes_of(std::span<const T> values) {
  return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

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

std::size_t GltfBuffer::add_index_accessor(std::size_t view, std::size_t count, int type) {
  accessors_.push_back({{"bufferView", view}, {"componentType", type}, {"count", count}, {"type", "SCALAR"}});
  return accessors_.size() - 1;
}

std::size_t GltfBuffer::add_indices(std::span<const std::uint16_t> indices) {
  return add_index_accessor(add_bytes(bytes_of(indices)), indices.size(), uint16_type);
}

std::size_t GltfBuffer::add_indices(std::span<const std::uint32_t> indices) {
  return add_index_accessor(add_bytes(bytes_of(indices)), indices.size(), uint32_type);
}

void append_number(std::string& file, std::size_t value) {
  for (int byte = 0; byte < 4; ++byte) file.push_back(static_cast<char>((value >> (8 * byte)) & 0xff));
}

/// Length, kind, content, and as much padding as brings it to a multiple of four bytes.
void append_chunk(std::string& file, std::string_view kind, std::string_view content, char padding) {
  const std::size_t padded = (content.size() + 3) / 4 * 4;
  append_number(file, padded);
  file += kind;
  file += content;
  file.append(padded - content.size(), padding);
}

/// Bytes in base64 (RFC 4648).
std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t byte = i; byte < i + 3; ++byte)
      group = group << 8 | (byte < bytes.size() ? static_cast<unsigned char>(bytes[byte]) : 0u);
    for (std::size_t digit = 0; digit < 4; ++digit) {
      const bool is_there = i + digit <= bytes.size();
      text.push_back(is_there ? digits[(group >> (18 - 6 * digit)) & 63] : '=');
    }
  }
  return text;
}

/// A .glb file of a document and its buffer (glTF 2.0, section 4).
std::string gltf_binary(std::string_view json, std::string_view buffer) {
  using namespace std::string_view_literals;
  std::string chunks;
  append_chunk(chunks, "JSON"sv, json, ' ');
  append_chunk(chunks, "BIN\0"sv, buffer, '\0');
  std::string file = "glTF";
  append_number(file, 2);
  append_number(file, 12 + chunks.size());
  return file + chunks;
}

using Json = nlohmann::ordered_json;

constexpr int linear_filter = 9729, mip_mapped_filter = 9987, clamp_to_edge = 33071;
// Of the square: positions and texture coordinates.
constexpr std::size_t square_positions = 0, square_places = 1, square_indices = 2;

/// Values of one node over its keys.
struct NodeKeys {
  std::vector<float> times_s, translations, rotations, scales, colours;

  void add_pose(double time_s, const glm::dvec3& place_m, const glm::dmat3& axes) {
    glm::dquat turn = glm::quat_cast(axes);
    // Both signs are one rotation: the one nearer to the last is taken, so that nothing spins in between.
    const std::size_t last = rotations.size();
    if (last >= 4) {
      const glm::dquat before(rotations[last - 1], rotations[last - 4], rotations[last - 3],
                              rotations[last - 2]);
      if (glm::dot(before, turn) < 0.0) turn = -turn;
    }
    times_s.push_back(static_cast<float>(time_s));
    for (const double value : {place_m.x, place_m.y, place_m.z})
      translations.push_back(static_cast<float>(value));
    for (const double value : {turn.x, turn.y, turn.z, turn.w})
      rotations.push_back(static_cast<float>(value));
  }
};

/// One projector through time.
struct Projector {
  std::size_t first = 0, last = 0;  ///< frames
  std::vector<std::pair<std::size_t, const ProjectorSample*>> samples;
};

using ProjectorKey = std::tuple<std::uint64_t, int, int>;  // id, rule, copy

std::map<ProjectorKey, Projector> projectors_of(const AnimatedMesh& mesh) {
  std::map<ProjectorKey, Projector> projectors;
  for (std::size_t frame = 0; frame < mesh.frames.size(); ++frame) {
    for (const ProjectorSample& sample : mesh.frames[frame].projectors)
      projectors[{sample.id, sample.rule, sample.copy}].samples.emplace_back(frame, &sample);
  }
  for (auto& [key, projector] : projectors) {
    const std::size_t first = projector.samples.front().first, last = projector.samples.back().first;
    projector.first = first == 0 ? 0 : first - 1;
    projector.last = std::min(last + 1, mesh.frames.size() - 1);
  }
  return projectors;
}

class Writer {
 public:
  explicit Writer(const HighlightAnimation& animation) : animation_(animation) {
    // Row 0 of a texture is its upper edge.
    constexpr std::array<float, 12> corners{-0.5f, -0.5f, 0.0f, 0.5f,  -0.5f, 0.0f,
                                            0.5f,  0.5f,  0.0f, -0.5f, 0.5f,  0.0f};
    constexpr std::array<float, 8> places{0.0f, 1.0f, 1.0f, 1.0f, 1.0f, 0.0f, 0.0f, 0.0f};
    constexpr std::array<std::uint16_t, 6> indices{0, 1, 2, 0, 2, 3};
    buffer_.add(corners, 3);
    buffer_.add(places, 2);
    buffer_.add_indices(indices);
    for (const AnimatedTexture& texture : animation.textures) add_texture(texture);
    for (const AnimatedMesh& mesh : animation.meshes) add_mesh(mesh);
    if (!animation.scene) return;
    add_camera(animation.scene->cameras);
    for (std::size_t i = 0; i < animation.scene->lights.size(); ++i)
      add_light(animation.scene->lights[i], animation.lights[i]);
  }

  Json document() const {
    Json json = {{"asset", {{"version", "2.0"}, {"generator", animation_.generator}}},
                 {"extensionsUsed", {"KHR_materials_unlit", "KHR_animation_pointer"}},
                 {"extras", {{"lights", animation_.lights}, {"lamps", animation_.lights}}},
                 {"scene", 0},
                 {"scenes", {{{"nodes", roots_}}}},
                 {"nodes", nodes_},
                 {"meshes", meshes_},
                 {"materials", materials_},
                 {"textures", textures_},
                 {"images", images_},
                 {"samplers",
                  {{{"magFilter", linear_filter},
                    {"minFilter", mip_mapped_filter},
                    {"wrapS", clamp_to_edge},
                    {"wrapT", clamp_to_edge}}}},
                 {"animations", {{{"name", "highlights"}, {"channels", channels_}, {"samplers", samplers_}}}},
                 {"bufferViews", buffer_.views()},
                 {"accessors", buffer_.accessors()}};
    if (!cameras_.empty()) json["cameras"] = cameras_;
    if (!lights_.empty()) {
      json["extensionsUsed"].push_back("KHR_lights_punctual");
      json["extensions"] = {{"KHR_lights_punctual", {{"lights", lights_}}}};
    }
    // An empty list is none to glTF.
    for (const char* name : {"nodes", "meshes", "materials", "textures", "images"}) {
      if (json[name].empty()) json.erase(name);
    }
    if (channels_.empty()) json.erase("animations");
    if (roots_.empty()) json["scenes"] = {Json::object()};
    return json;
  }
  const std::string& bytes() const { return buffer_.bytes(); }

 private:
  double time_s(std::size_t frame) const {
    return (animation_.first_frame + static_cast<double>(frame)) / animation_.frames_per_s;
  }

  void add_texture(const AnimatedTexture& texture) {
    if (texture.file.empty()) {
      images_.push_back({{"name", texture.name},
                         {"mimeType", "image/png"},
                         {"bufferView", buffer_.add_bytes(png_bytes(texture.image))}});
    } else {
      images_.push_back({{"name", texture.name}, {"uri", encode_percent(texture.file)}});
    }
    textures_.push_back({{"source", images_.size() - 1}, {"sampler", 0}});
  }

  void add_channel(Json target, std::size_t times, std::size_t values) {
    samplers_.push_back({{"input", times}, {"output", values}});
    channels_.push_back({{"sampler", samplers_.size() - 1}, {"target", std::move(target)}});
  }

  /// The first key is how the node stands where animations are left out.
  void set_pose(std::size_t node, const NodeKeys& keys) {
    const auto first = [](const std::vector<float>& values, std::ptrdiff_t count) {
      return std::vector<float>(values.begin(), values.begin() + count);
    };
    nodes_[node]["translation"] = first(keys.translations, 3);
    nodes_[node]["rotation"] = first(keys.rotations, 4);
    if (!keys.scales.empty()) nodes_[node]["scale"] = first(keys.scales, 3);
  }

  void add_poses(std::size_t node, const NodeKeys& keys, std::size_t times) {
    set_pose(node, keys);
    add_channel({{"node", node}, {"path", "translation"}}, times, buffer_.add(keys.translations, 3));
    add_channel({{"node", node}, {"path", "rotation"}}, times, buffer_.add(keys.rotations, 4));
    if (!keys.scales.empty())
      add_channel({{"node", node}, {"path", "scale"}}, times, buffer_.add(keys.scales, 3));
  }

  /// A channel for a number or numbers of the document, at its path.
  void add_pointer(std::string pointer, std::size_t times, std::size_t values) {
    add_channel(
        {{"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", {{"pointer", std::move(pointer)}}}}}},
        times, values);
  }

  /// The same for values that change; others stay as the document has them. Times are those of all frames.
  void add_changes(std::string pointer, std::span<const float> values, std::size_t components) {
    if (changes(values, components))
      add_pointer(std::move(pointer), frame_times(values.size() / components),
                  buffer_.add(values, components));
  }

  static bool changes(std::span<const float> values, std::size_t components) {
    return !std::equal(values.begin() + static_cast<std::ptrdiff_t>(components), values.end(),
                       values.begin());
  }

  /// The accessor of the times of all frames.
  std::size_t frame_times(std::size_t count) {
    if (!frame_times_) {
      std::vector<float> times_s;
      for (std::size_t frame = 0; frame < count; ++frame)
        times_s.push_back(static_cast<float>(time_s(frame)));
      frame_times_ = buffer_.add(times_s, 1);
    }
    return *frame_times_;
  }

  /// A node beside the meshes, with keys if it moves.
  void add_root(Json node, const NodeKeys& keys) {
    roots_.push_back(nodes_.size());
    nodes_.push_back(std::move(node));
    if (changes(keys.translations, 3) || changes(keys.rotations, 4)) {
      add_poses(nodes_.size() - 1, keys, frame_times(keys.times_s.size()));
    } else {
      set_pose(nodes_.size() - 1, keys);
    }
  }

  void add_camera(const std::vector<Camera>& cameras) {
    NodeKeys keys;
    std::vector<float> fields_rad;
    for (std::size_t frame = 0; frame < cameras.size(); ++frame) {
      const CameraBasis axes = basis(cameras[frame]);
      keys.add_pose(time_s(frame), cameras[frame].eye_m, {axes.right, axes.up, -axes.forward});
      fields_rad.push_back(static_cast<float>(cameras[frame].vertical_field_of_view_rad));
    }
    constexpr double near_m = 0.1;  // glTF wants one
    cameras_.push_back({{"name", "camera"},
                        {"type", "perspective"},
                        {"perspective", {{"yfov", fields_rad[0]}, {"znear", near_m}}}});
    add_root({{"name", "camera"}, {"camera", 0}}, keys);
    add_changes("/cameras/0/perspective/yfov", fields_rad, 1);
  }

  void add_light(const AnimatedLight& light, const std::string& name) {
    // A light without a name is known by its number.
    const std::string shown = name.empty() ? fmt::format("light {}", lights_.size()) : name;
    // Lux of distant lights; candela of near ones, which glTF dims by the square of the distance.
    const double intensity_per_klx = 1000.0 * (light.is_near ? light.distance_m * light.distance_m : 1.0);
    NodeKeys keys;
    std::vector<float> colours, intensities;
    for (std::size_t frame = 0; frame < light.frames.size(); ++frame) {
      const LightFrame& at = light.frames[frame];
      // glTF's lights shine along -z.
      keys.add_pose(time_s(frame), light.is_near ? at.vector : glm::dvec3(0.0),
                    light.is_near ? glm::dmat3(1.0) : axes_along(at.vector));
      const double brightest_klx =
          std::max({at.illuminance_klx.r, at.illuminance_klx.g, at.illuminance_klx.b});
      for (int c = 0; c < 3; ++c)
        colours.push_back(
            static_cast<float>(brightest_klx > 0.0 ? at.illuminance_klx[c] / brightest_klx : 1.0));
      intensities.push_back(static_cast<float>(intensity_per_klx * brightest_klx));
    }
    const std::string path = fmt::format("/extensions/KHR_lights_punctual/lights/{}/", lights_.size());
    lights_.push_back({{"name", shown},
                       {"type", light.is_near ? "point" : "directional"},
                       {"color", {colours[0], colours[1], colours[2]}},
                       {"intensity", intensities[0]}});
    add_root({{"name", shown},
              {"extensions", {{"KHR_lights_punctual", {{"light", lights_.size() - 1}}}}},
              {"extras", {{"light", lights_.size() - 1}}}},
             keys);
    add_changes(path + "color", colours, 3);
    add_changes(path + "intensity", intensities, 1);
  }

  /// Right-handed axes with this z.
  static glm::dmat3 axes_along(const glm::dvec3& z) {
    const glm::dvec3 aside = std::abs(z.y) < 0.999 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(0.0, 0.0, 1.0);
    const glm::dvec3 x = glm::normalize(glm::cross(aside, z));
    return {x, glm::cross(z, x), z};
  }

  std::size_t add_vectors(const std::vector<glm::dvec3>& vectors) {
    std::vector<float> values;
    for (const glm::dvec3& vector : vectors) {
      for (int c = 0; c < 3; ++c) values.push_back(static_cast<float>(vector[c]));
    }
    return buffer_.add(values, 3);
  }

  std::size_t add_differences(std::vector<glm::dvec3> vectors, const std::vector<glm::dvec3>& at_rest) {
    for (std::size_t i = 0; i < vectors.size(); ++i) vectors[i] -= at_rest[i];
    return add_vectors(vectors);
  }

  /// Gives a mesh that deforms a morph target for each of its forms. Of the targets of a frame one has the
  /// weight 1, so that vertices go straight from frame to frame.
  void add_forms(const AnimatedMesh& mesh, std::size_t node) {
    const TriangleMesh& at_rest = *mesh.look->mesh;
    std::map<const MeshForm*, std::size_t> forms;  // with their numbers
    std::vector<std::size_t> form_of_frame;        // [frames]; beyond all forms: at rest
    Json targets = Json::array(), names = Json::array();
    for (std::size_t frame = 0; frame < mesh.frames.size(); ++frame) {
      const MeshForm* form = mesh.frames[frame].form.get();
      if (form == nullptr) {
        form_of_frame.push_back(mesh.frames.size());
        continue;
      }
      const auto [known, is_new] = forms.try_emplace(form, forms.size());
      form_of_frame.push_back(known->second);
      if (!is_new) continue;
      names.push_back(fmt::format("frame {}", animation_.first_frame + static_cast<int>(frame)));
      targets.push_back({{"POSITION", add_differences(form->positions_m, at_rest.positions_m)}});
      if (!at_rest.normals.empty() && !form->normals.empty())
        targets.back()["NORMAL"] = add_differences(form->normals, at_rest.normals);
    }
    if (forms.empty()) return;
    std::vector<float> weights(mesh.frames.size() * forms.size(), 0.0f);
    for (std::size_t frame = 0; frame < mesh.frames.size(); ++frame) {
      if (form_of_frame[frame] < forms.size()) weights[frame * forms.size() + form_of_frame[frame]] = 1.0f;
    }
    Json& made = meshes_[nodes_[node]["mesh"].get<std::size_t>()];
    made["primitives"][0]["targets"] = std::move(targets);
    made["weights"] =
        std::vector<float>(weights.begin(), weights.begin() + static_cast<std::ptrdiff_t>(forms.size()));
    made["extras"] = {{"targetNames", std::move(names)}};  // where programs look for them
    if (changes(weights, forms.size()))
      add_channel({{"node", node}, {"path", "weights"}}, frame_times(mesh.frames.size()),
                  buffer_.add(weights, 1));
  }

  /// A mesh with a material of its name: the index of the mesh.
  std::size_t add_look(const MeshLook& look, const std::string& name) {
    const TriangleMesh& mesh = *look.mesh;
    std::vector<std::uint32_t> corners;
    for (const TriangleIndices& face : mesh.faces) corners.insert(corners.end(), face.begin(), face.end());
    Json attributes = {{"POSITION", add_vectors(mesh.positions_m)}};
    if (!mesh.normals.empty()) attributes["NORMAL"] = add_vectors(mesh.normals);
    materials_.push_back({{"name", name},
                          {"pbrMetallicRoughness",
                           {{"baseColorFactor", {look.colour.r, look.colour.g, look.colour.b, 1.0}},
                            {"metallicFactor", 0.0},
                            {"roughnessFactor", 1.0}}},
                          {"doubleSided", true}});
    meshes_.push_back({{"name", name},
                       {"primitives",
                        {{{"attributes", std::move(attributes)},
                          {"indices", buffer_.add_indices(std::span<const std::uint32_t>(corners))},
                          {"material", materials_.size() - 1}}}}});
    return meshes_.size() - 1;
  }

  void add_mesh(const AnimatedMesh& mesh) {
    const std::size_t node = nodes_.size();
    Json extras = {{"scale", mesh.scale}};
    if (!mesh.file.empty()) extras["file"] = mesh.file;
    nodes_.push_back({{"name", mesh.name}, {"extras", std::move(extras)}});
    roots_.push_back(node);
    if (mesh.look) {
      nodes_[node]["mesh"] = add_look(*mesh.look, mesh.name);
      add_forms(mesh, node);
    }
    NodeKeys keys;
    for (std::size_t frame = 0; frame < mesh.frames.size(); ++frame)
      keys.add_pose(time_s(frame), mesh.frames[frame].translation_m, mesh.frames[frame].rotation);
    if (!mesh.frames.empty()) add_poses(node, keys, buffer_.add(keys.times_s, 1));
    Json children = Json::array();
    for (const auto& [key, projector] : projectors_of(mesh)) {
      children.push_back(nodes_.size());
      add_projector(projector);
    }
    if (!children.empty()) nodes_[node]["children"] = std::move(children);
  }

  /// A key a frame; where a projector is not there, the pose of the nearest time that it was, without a size.
  NodeKeys keys_of(const Projector& projector) const {
    NodeKeys keys;
    std::size_t nearest = 0;
    const auto off = [&](std::size_t i, std::size_t frame) {
      const std::size_t there = projector.samples[i].first;
      return there > frame ? there - frame : frame - there;
    };
    for (std::size_t frame = projector.first; frame <= projector.last; ++frame) {
      while (nearest + 1 < projector.samples.size() && off(nearest + 1, frame) < off(nearest, frame))
        ++nearest;
      const ProjectorSample& sample = *projector.samples[nearest].second;
      const bool is_there = off(nearest, frame) == 0;
      keys.add_pose(time_s(frame), sample.position_m, glm::dmat3(sample.right, sample.up, sample.normal));
      const double size = is_there ? 1.0 : 0.0;
      for (const double length_m :
           {sample.width_m, sample.height_m, std::max(sample.width_m, sample.height_m)})
        keys.scales.push_back(static_cast<float>(size * length_m));
      for (int channel = 0; channel < 3; ++channel)
        keys.colours.push_back(static_cast<float>(std::min(sample.colour[channel], 1.0)));
      keys.colours.push_back(static_cast<float>(size * sample.opacity));
    }
    return keys;
  }

  void add_projector(const Projector& projector) {
    const ProjectorSample& sample = *projector.samples.front().second;
    const NodeKeys keys = keys_of(projector);
    const Json first_colour = {keys.colours[0], keys.colours[1], keys.colours[2], keys.colours[3]};
    const std::string name = fmt::format("highlight {}.{}.{}", sample.id, sample.rule, sample.copy);
    // Blender's importer stops at an unlit material without a name.
    materials_.push_back(
        {{"name", name},
         {"pbrMetallicRoughness",
          {{"baseColorFactor", first_colour}, {"baseColorTexture", {{"index", sample.texture}}}}},
         {"alphaMode", "BLEND"},
         {"doubleSided", true},
         {"extensions", {{"KHR_materials_unlit", Json::object()}}}});
    meshes_.push_back({{"name", name},
                       {"primitives",
                        {{{"attributes", {{"POSITION", square_positions}, {"TEXCOORD_0", square_places}}},
                          {"indices", square_indices},
                          {"material", materials_.size() - 1}}}}});
    const std::size_t node = nodes_.size();
    nodes_.push_back({{"name", name},
                      {"mesh", meshes_.size() - 1},
                      {"extras",
                       {{"id", sample.id},
                        {"rule", sample.rule},
                        {"copy", sample.copy},
                        {"light", sample.light < 0 ? Json() : Json(sample.light)},
                        {"lamp", sample.light < 0 ? Json() : Json(sample.light)},  // its earlier name
                        {"texture", animation_.textures[sample.texture].name},
                        {"softness", sample.softness}}}});
    const std::size_t times = buffer_.add(keys.times_s, 1);
    add_poses(node, keys, times);
    add_pointer(fmt::format("/materials/{}/pbrMetallicRoughness/baseColorFactor", materials_.size() - 1),
                times, buffer_.add(keys.colours, 4));
  }

  const HighlightAnimation& animation_;
  GltfBuffer buffer_;
  Json nodes_ = Json::array(), roots_ = nodes_, meshes_ = nodes_, materials_ = nodes_, textures_ = nodes_,
       images_ = nodes_, channels_ = nodes_, samplers_ = nodes_, cameras_ = nodes_, lights_ = nodes_;
  std::optional<std::size_t> frame_times_;  // their accessor
};

}  // namespace

std::string highlight_animation_gltf(const HighlightAnimation& animation, GltfForm form) {
  const Writer writer(animation);
  Json document = writer.document();
  Json buffer = {{"byteLength", writer.bytes().size()}};
  if (form == GltfForm::text) {
    buffer["uri"] = "data:application/octet-stream;base64," + base64(writer.bytes());
    document["buffers"] = {std::move(buffer)};
    return document.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
  }
  document["buffers"] = {std::move(buffer)};
  return gltf_binary(document.dump(-1, ' ', false, Json::error_handler_t::replace), writer.bytes());
}

}  // namespace offing::animations
