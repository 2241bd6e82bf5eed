#include "host/io/meshes/gltf_stage.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host/io/meshes/gltf_document.h"
#include "host/io/meshes/mesh_bytes.h"

namespace offing::meshes {
namespace {

using nlohmann::json;

constexpr const char* lights_extension = "KHR_lights_punctual";

class StageParser {
 public:
  StageParser(std::string_view bytes, const std::filesystem::path& path, Trust trust,
              const std::string& animation)
      : document_(bytes, path, trust) {
    stage_.nodes = std::make_shared<const GltfScene>(
        document_, animation, [this](std::string_view what, std::size_t count) { leave_out(what, count); });
  }

  GltfStage parse() && {
    for (const std::size_t node : stage_.nodes->nodes()) {
      const json& object = document_.object("nodes", node);
      if (object.contains("mesh")) stage_.has_meshes = true;
      if (object.contains("camera")) add_camera(object, node);
      if (const json* light = extension_of(object)) add_light(object, node, *light);
    }
    if (document_.count("nodes") == 0) stage_.has_meshes = document_.count("meshes") > 0;
    leave_out("materials", document_.count("materials"));
    leave_out("textures", document_.count("textures"));
    return std::move(stage_);
  }

 private:
  void leave_out(std::string_view what, std::size_t count) {
    if (count == 0) return;
    const auto found = std::ranges::find(stage_.left_out, what, &LeftOut::what);
    if (found == stage_.left_out.end()) {
      stage_.left_out.push_back({std::string(what), count});
    } else {
      found->count += count;
    }
  }

  /// An object's part for lights; nullptr where it has none.
  const json* extension_of(const json& object) const {
    const auto extensions = object.find("extensions");
    if (extensions == object.end() || !extensions->is_object()) return nullptr;
    const auto found = extensions->find(lights_extension);
    if (found == extensions->end()) return nullptr;
    if (!found->is_object())
      document_.fail(fmt::format("an object {}", lights_extension), found->type_name());
    return &*found;
  }

  /// That of the node; without one, that of what it shows.
  static std::string name_of(const json& node, const json& shown) {
    for (const json* object : {&node, &shown}) {
      const auto name = object->find("name");
      if (name != object->end() && name->is_string()) return name->get<std::string>();
    }
    return "";
  }

  double number(const json& object, const char* key, std::optional<double> otherwise) const {
    const auto found = object.find(key);
    if (found == object.end() && otherwise) return *otherwise;
    if (found == object.end() || !found->is_number() || !std::isfinite(found->get<double>()))
      document_.fail(fmt::format("a number {}", key), found == object.end() ? "none" : shown(*found));
    return found->get<double>();
  }

  void add_camera(const json& node, std::size_t index) {
    const std::size_t which = document_.whole(node, "camera", std::nullopt);
    const json& camera = document_.object("cameras", which);
    const auto perspective = camera.find("perspective");
    if (perspective == camera.end() || !perspective->is_object()) {
      leave_out("orthographic cameras", 1);
      return;
    }
    const double yfov_rad = number(*perspective, "yfov", std::nullopt);
    if (!(yfov_rad > 0.0 && yfov_rad < std::numbers::pi))
      document_.fail(fmt::format("a yfov between 0 and pi in cameras[{}]", which),
                     fmt::format("{:g}", yfov_rad));
    stage_.cameras.push_back(
        {.name = name_of(node, camera), .node = index, .vertical_field_of_view_rad = yfov_rad});
  }

  void add_light(const json& node, std::size_t index, const json& named) {
    const json* const all = extension_of(document_.root());
    const std::size_t which = document_.whole(named, "light", std::nullopt);
    const auto lights = all == nullptr ? json::const_iterator() : all->find("lights");
    if (all == nullptr || lights == all->end() || !lights->is_array() || which >= lights->size() ||
        !(*lights)[which].is_object()) {
      document_.fail(fmt::format("a light {} of {}", which, lights_extension), "none");
    }
    const json& light = (*lights)[which];
    const json type = light.value("type", json());
    if (type != "directional" && type != "point" && type != "spot")
      document_.fail(fmt::format("directional, point or spot in lights[{}]", which), shown(type));
    GltfLight made{.name = name_of(node, light), .node = index, .is_directional = type == "directional"};
    if (const std::vector<double> c = document_.numbers(light, "color", 3); !c.empty())
      made.colour = {c[0], c[1], c[2]};
    made.intensity = number(light, "intensity", 1.0);
    for (const double part : {made.colour.x, made.colour.y, made.colour.z, made.intensity}) {
      if (part < 0.0)
        document_.fail(fmt::format("colour and intensity of at least 0 in lights[{}]", which),
                       fmt::format("{:g}", part));
    }
    if (type == "spot") leave_out("cones of spot lights", 1);
    if (light.contains("range")) leave_out("ranges of lights", 1);
    stage_.lights.push_back(std::move(made));
  }

  GltfDocument document_;
  GltfStage stage_;
};

}  // namespace

GltfStage parse_gltf_stage(std::string_view bytes, const std::filesystem::path& path, Trust trust,
                           const std::string& animation) {
  return StageParser(bytes, path, trust, animation).parse();
}

GltfStage read_gltf_stage(const std::filesystem::path& path, Trust trust, const std::string& animation) {
  return parse_mesh_file(
      path, [&](std::string_view bytes) { return parse_gltf_stage(bytes, path, trust, animation); });
}

}  // namespace offing::meshes
