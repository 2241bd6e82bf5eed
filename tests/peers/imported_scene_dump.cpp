// What blender_import_test.py compares an imported scene with, as JSON.
//   imported_scene_dump pixels SCENE INPUT      pixels of places of the world that INPUT lists by frame
//   imported_scene_dump highlights SCENE INPUT  highlights of a mesh whose forms INPUT lists by frame, by the
//                                               C++ interface without a reader of files
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "host/base/camera.h"
#include "host/highlights/curvature/diffused_curvature.h"
#include "host/highlights/projectors/drawn_highlights.h"
#include "host/highlights/tracks/highlight_tracker.h"
#include "host/scene/file/scene_file.h"
#include "host/scene/prepare/moving_view.h"
#include "host/scene/prepare/scene_meshes.h"

namespace {

using namespace offing;
using nlohmann::json;

std::vector<glm::dvec3> places_of(const json& list) {
  std::vector<glm::dvec3> places_m;
  for (const json& place : list) places_m.emplace_back(place[0], place[1], place[2]);
  return places_m;
}

json list_of(const glm::dvec3& v) {
  return {v.x, v.y, v.z};
}

/// Pixels from the upper left corner of the picture, frame by frame.
json pixels(const scene::Scene& scene, const json& input) {
  json frames = json::array();
  for (std::size_t frame = 0; frame < input["places_m"].size(); ++frame) {
    Camera camera = scene::view_at(scene, static_cast<double>(frame) / input["fps"].get<double>()).camera;
    camera.width_px = input["width_px"];
    camera.height_px = input["height_px"];
    const glm::dmat4 to_clip = projection(camera, 0.01) * view_rotation(camera);
    json& found = frames.emplace_back(json::array());
    for (const glm::dvec3& place_m : places_of(input["places_m"][frame])) {
      const glm::dvec4 clip = to_clip * glm::dvec4(place_m - camera.eye_m, 1.0);
      found.push_back({(0.5 + 0.5 * clip.x / clip.w) * camera.width_px,
                       (0.5 - 0.5 * clip.y / clip.w) * camera.height_px});
    }
  }
  return frames;
}

json highlights_of(const scene::Scene& scene, const json& input) {
  const double step_s = 1.0 / input["fps"].get<double>();
  std::vector<std::vector<glm::dvec3>> forms;
  for (const json& form : input["forms_m"]) forms.push_back(places_of(form));
  TriangleMesh mesh{.positions_m = forms.front(), .normals = {}, .faces = input["faces"]};
  const ocl::Device device = ocl::Device::open();
  highlights::DiffusedCurvature curvature(device, mesh);
  highlights::HighlightSurface surface(device, mesh, curvature.of(mesh.positions_m));
  const highlights::LightingAt lighting = scene::lighting_of(scene);
  highlights::TrackOptions options{.step_s = step_s};
  options.has_shadows = true;
  highlights::HighlightTracker tracks(
      surface,
      [&](double time_s) {
        const auto frame = std::min(static_cast<std::size_t>(time_s / step_s + 0.5), forms.size() - 1);
        surface.deform(forms[frame], {}, curvature.of(forms[frame]));
        return lighting(time_s);
      },
      options);
  highlights::HighlightDrawing drawing(surface, tracks.options().size);
  tracks.reset(0.0);
  json frames = json::array();
  for (std::size_t frame = 0; frame < forms.size(); ++frame) {
    const double time_s = static_cast<double>(frame) * step_s;
    drawing.update(tracks.shown_at(time_s), {}, static_cast<int>(lighting(time_s).lights.size()));
    json& found = frames.emplace_back(json::array());
    for (const highlights::DrawnHighlight& drawn : drawing.highlights()) {
      if (!(drawn.opacity > 0.0)) continue;
      found.push_back({{"id", drawn.id},
                       {"light", drawn.light},
                       {"position_m", list_of(drawn.projector.centre_m)},
                       {"diagonal_m", surface.diagonal_m()}});
    }
  }
  return frames;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 4) return EXIT_FAILURE;
  const scene::Scene scene = scene::load_scene(arguments[2]);
  std::ifstream file(arguments[3]);
  const json input = json::parse(file);
  const json result =
      std::string(arguments[1]) == "pixels" ? pixels(scene, input) : highlights_of(scene, input);
  std::puts(result.dump().c_str());
  return EXIT_SUCCESS;
}
