#include <glm/gtc/quaternion.hpp>
#include <nlohmann/json.hpp>

#include "host/io/animations/highlight_animation.h"

namespace offing::animations {
namespace {

using Json = nlohmann::ordered_json;  // in the order of the description

Json list_of(const glm::dvec3& v) {
  return {v.x, v.y, v.z};
}

Json projector_json(const MeshFrame& frame, const ProjectorSample& projector) {
  return {{"id", projector.id},
          {"rule", projector.rule},
          {"copy", projector.copy},
          {"light", projector.light < 0 ? Json() : Json(projector.light)},
          {"lamp", projector.light < 0 ? Json() : Json(projector.light)},  // its earlier name
          {"position_m", list_of(frame.rotation * projector.position_m + frame.translation_m)},
          {"right", list_of(frame.rotation * projector.right)},
          {"up", list_of(frame.rotation * projector.up)},
          {"normal", list_of(frame.rotation * projector.normal)},
          {"width_m", projector.width_m},
          {"height_m", projector.height_m},
          {"opacity", projector.opacity},
          {"texture", projector.texture},
          {"softness", projector.softness},
          {"colour", list_of(projector.colour)}};
}

Json frame_json(const HighlightAnimation& animation, int index, const MeshFrame& frame) {
  const glm::dquat turn = glm::quat_cast(frame.rotation);
  Json highlights = Json::array();
  for (const ProjectorSample& projector : frame.projectors)
    highlights.push_back(projector_json(frame, projector));
  const int number = animation.first_frame + index;
  return {{"frame", number},
          {"time_s", number / animation.frames_per_s},
          {"mesh",
           {{"translation_m", list_of(frame.translation_m)}, {"rotation", {turn.x, turn.y, turn.z, turn.w}}}},
          {"highlights", std::move(highlights)}};
}

}  // namespace

std::string highlight_animation_json(const HighlightAnimation& animation) {
  Json textures = Json::array();
  for (const AnimatedTexture& texture : animation.textures) {
    Json json = {{"name", texture.name}};
    if (!texture.file.empty()) json["file"] = texture.file;
    textures.push_back(std::move(json));
  }
  Json meshes = Json::array();
  for (const AnimatedMesh& mesh : animation.meshes) {
    Json frames = Json::array();
    for (std::size_t i = 0; i < mesh.frames.size(); ++i)
      frames.push_back(frame_json(animation, static_cast<int>(i), mesh.frames[i]));
    Json json = {{"name", mesh.name}};
    if (!mesh.file.empty()) json["file"] = mesh.file;
    json["scale"] = mesh.scale;
    json["frames"] = std::move(frames);
    meshes.push_back(std::move(json));
  }
  const std::size_t frame_count = animation.meshes.empty() ? 0 : animation.meshes.front().frames.size();
  const Json json = {{"generator", animation.generator},
                     {"version", 1},
                     {"frames_per_s", animation.frames_per_s},
                     {"first_frame", animation.first_frame},
                     {"frame_count", frame_count},
                     {"lights", animation.lights},
                     {"lamps", animation.lights},  // its earlier name
                     {"textures", std::move(textures)},
                     {"meshes", std::move(meshes)}};
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace offing::animations
