#include "host/scene/schema/unused_mesh_parameters.h"

#include "host/scene/schema/parameter_table.h"

namespace offing::scene {

namespace {

using highlights::HighlightTexture;

/// "the shading is phong".
std::string is_text(const Scene& scene, const char* what, const char* key, ElementIndex element) {
  return std::string("the ") + what + " is " +
         value_text(scene, *find_parameter(key), element, Digits::readable);
}

}  // namespace

std::string against_light(const LightScene& light, ParameterUse use) {
  if (use == ParameterUse::far_light && light.kind == LightKind::place) return "the light stands at a place";
  if (use == ParameterUse::near_light && light.kind == LightKind::direction) {
    return "the light is of kind direction";
  }
  return "";
}

std::string against_mesh(const Scene& scene, ElementIndex element, ParameterUse use) {
  const MeshScene& mesh = scene.meshes[element.outer];
  // What moves may be there at another time.
  const auto is_never = [&](const char* key, double value) {
    return value == 0.0 && !scene.tracks.contains({key, element});
  };
  switch (use) {
    case ParameterUse::made_mesh:
      return mesh.file.empty() ? "" : "the mesh is that of " + mesh.file;
    case ParameterUse::stepped_mesh:
      if (!mesh.cartoon_ramp.empty()) return "mesh.cartoon_ramp is given";
      [[fallthrough]];
    case ParameterUse::cartoon_mesh:
      return mesh.material.shading == world::BaseShading::cartoon
                 ? ""
                 : is_text(scene, "shading", "mesh.shading", element);
    case ParameterUse::outlined_mesh:
      return is_never("mesh.outline_px", mesh.material.outline_px) ? "the mesh has no outline" : "";
    case ParameterUse::shiny_mesh:
      return is_never("mesh.specular", mesh.material.specular) ? "mesh.specular is 0" : "";
    case ParameterUse::found_highlights:
      return mesh.shown == MeshHighlights::on ? "" : "the mesh's highlights are off";
    default:
      return "";
  }
}

std::string against_body(const BodyScene& body, ParameterUse use) {
  if (use == ParameterUse::body_of_density) {
    if (body.draught_m) return "body.draught_m is given";
    if (body.mass_kg) return "body.mass_kg is given";
  }
  if (use == ParameterUse::driven_body && body.motion == BodyMotion::path) return "the body follows its path";
  return "";
}

std::string against_highlight(const Scene& scene, ElementIndex element, ParameterUse use) {
  const highlights::HighlightRule& rule = scene.meshes[element.outer].highlights[element.inner].rule;
  if (std::string reason = against_mesh(scene, element, ParameterUse::found_highlights); !reason.empty()) {
    return reason;
  }
  const bool has_image = is_image(rule.controls.texture);
  switch (use) {
    case ParameterUse::masked_highlight:
      return rule.mask_m ? "" : "mesh.highlight.mask_m is not given";
    case ParameterUse::split_highlight:
      return rule.controls.split > 1 ? "" : "mesh.highlight.split is 1";
    case ParameterUse::shape_highlight:
      return has_image ? is_text(scene, "texture", "mesh.highlight.texture", element) : "";
    case ParameterUse::image_highlight:
      return has_image ? "" : is_text(scene, "texture", "mesh.highlight.texture", element);
    default:
      return "";
  }
}

}  // namespace offing::scene
