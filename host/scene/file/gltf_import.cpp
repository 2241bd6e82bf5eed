#include "host/scene/file/gltf_import.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "host/base/error.h"
#include "host/io/meshes/gltf_stage.h"
#include "host/io/meshes/read_mesh.h"
#include "host/scene/file/nearest_name.h"
#include "host/scene/file/parameter_track.h"
#include "host/scene/file/scene_file.h"
#include "host/scene/file/scene_writer.h"
#include "host/scene/schema/parameter_table.h"

namespace offing::scene {
namespace {

constexpr double most_klx = 1000.0;  // that a light of a scene can have
constexpr double night_elevation_rad = -std::numbers::pi / 6.0;

/// The column of a node's matrix as a direction.
glm::dvec3 axis_of(const glm::dmat4& to_world, int axis) {
  const glm::dvec3 column(to_world[axis]);
  const double length = glm::length(column);
  if (length > 0.0) return column / length;
  glm::dvec3 own(0.0);
  own[axis] = 1.0;
  return own;
}

/// A camera at a node, which looks along its -z axis with +y up.
Camera camera_at(const glm::dmat4& to_world, const meshes::GltfCamera& camera) {
  const glm::dvec3 forward = -axis_of(to_world, 2), up = axis_of(to_world, 1);
  const glm::dvec3 right = glm::cross(forward, up);
  Camera made = ViewScene{}.camera;
  made.eye_m = glm::dvec3(to_world[3]);
  made.vertical_field_of_view_rad = camera.vertical_field_of_view_rad;
  made.pitch_rad = std::asin(std::clamp(forward.y, -1.0, 1.0));
  // Straight up or down there is no yaw but that of the picture's up.
  constexpr double level = 1e-9;
  const bool is_upright = std::hypot(forward.x, forward.z) > level;
  const glm::dvec3 ahead = is_upright ? forward : (forward.y > 0.0 ? -up : up);
  made.yaw_rad = std::atan2(ahead.x, -ahead.z);
  const CameraBasis without_roll = basis(made);
  made.roll_rad = std::atan2(-glm::dot(right, without_roll.up), glm::dot(right, without_roll.right));
  made.eye_m += 0.0;  // so that no zero has a sign
  for (double* angle_rad : {&made.yaw_rad, &made.pitch_rad, &made.roll_rad}) *angle_rad += 0.0;
  return made;
}

/// Without the keys that lie on the line between their neighbours. A scene turns the short way between two
/// keys, so the keys of an angle stay less than a third of its period apart.
std::vector<Keyframe> without_straight_ones(const std::vector<Keyframe>& keys, double period) {
  double largest = 0.0;
  for (const Keyframe& key : keys) largest = std::max(largest, std::abs(key.value));
  const double tolerance = 1e-9 * std::max(largest, 1e-3);
  std::vector<Keyframe> kept;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (i > 0 && i + 1 < keys.size()) {
      const Keyframe &before = kept.back(), &after = keys[i + 1];
      const double t = (keys[i].time_s - before.time_s) / (after.time_s - before.time_s);
      const bool is_straight = std::abs(std::lerp(before.value, after.value, t) - keys[i].value) <= tolerance;
      const bool is_near = period == 0.0 || std::abs(after.value - before.value) < period / 3.0;
      if (is_straight && is_near) continue;
    }
    kept.push_back(keys[i]);
  }
  const bool is_still = std::ranges::all_of(
      kept, [&](const Keyframe& key) { return std::abs(key.value - kept.front().value) <= tolerance; });
  if (is_still) kept.resize(1);
  return kept;
}

class GltfImporter {
 public:
  GltfImporter(const std::filesystem::path& file, const GltfChoice& choice, Trust trust)
      : file_(file),
        choice_(choice),
        trust_(trust),
        stage_(meshes::read_gltf_stage(file, trust, choice.animation)) {
    imported_.left_out = stage_.left_out;
  }

  ImportedScene import() && {
    require_counts();
    set_times();
    if (stage_.has_meshes) add_mesh();
    add_cameras();
    for (const meshes::GltfLight& light : stage_.lights) add_light(light);
    if (!stage_.lights.empty()) imported_.scene.view.sun_direction.elevation_rad = night_elevation_rad;
    require_readable();
    return std::move(imported_);
  }

 private:
  [[noreturn]] void fail(const std::string& expected, const std::string& got, const std::string& hint) const {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected {}, got {}", one_line(file_.string()), expected, got), hint);
  }

  void require_counts() const {
    const auto require = [&](const char* what, std::size_t count, std::string_view key) {
      const std::size_t most = find_parameter(key)->max_count;
      if (count > most)
        fail(fmt::format("at most {} {}", most, what), fmt::format("{}", count), "remove some from the file");
    };
    require("cameras", stage_.cameras.size(), "bookmark.name");
    require("lights", stage_.lights.size(), "light.name");
  }

  void set_times() {
    imported_.scene.time.frames_per_second = choice_.frames_per_s;
    const double end_s = stage_.nodes->end_s();
    // A last frame that rounding takes behind a whole number is that one.
    const double frames = std::ceil(end_s * choice_.frames_per_s - 1e-6);
    if (frames >= static_cast<double>(most_keyframes)) {
      fail(fmt::format("an animation of fewer than {} frames", most_keyframes), fmt::format("{:.0f}", frames),
           "take fewer of them: --fps 1");
    }
    if (end_s > 0.0) imported_.scene.time.end_s = end_s;
    constexpr double most_matrices = 1e8;  // some ten seconds
    if (frames * static_cast<double>(stage_.nodes->nodes().size()) > most_matrices)
      fail(fmt::format("at most {:g} frames times nodes", most_matrices),
           fmt::format("{:.0f} frames of {} nodes", frames, stage_.nodes->nodes().size()),
           "take fewer frames: --fps 1");
    std::set<std::size_t> nodes;  // one may have both
    for (const meshes::GltfCamera& camera : stage_.cameras) nodes.insert(camera.node);
    for (const meshes::GltfLight& light : stage_.lights) nodes.insert(light.node);
    for (int frame = 0; frame <= static_cast<int>(frames); ++frame) {
      times_s_.push_back(frame / choice_.frames_per_s);
      const std::vector<glm::dmat4> to_world = stage_.nodes->to_world(times_s_.back());
      for (const std::size_t node : nodes) to_world_[node].push_back(to_world[node]);
    }
  }

  void add_mesh() {
    const MeshFile file = read_mesh_file(file_, trust_, choice_.animation);
    for (const LeftOut& item : file.report.left_out) {
      const bool is_known =
          std::ranges::find(imported_.left_out, item.what, &LeftOut::what) != imported_.left_out.end();
      if (!is_known) imported_.left_out.push_back(item);
    }
    MeshScene& mesh = imported_.scene.meshes.emplace_back();
    mesh.name = file_.stem().string();
    mesh.file = file_.string();
    mesh.animation = choice_.animation;
    const MeshForm form = file.deformation ? file.deformation.form_at(0.0) : MeshForm{};
    const std::vector<glm::dvec3>& places_m = file.deformation ? form.positions_m : file.mesh.positions_m;
    glm::dvec3 low = places_m.front(), high = low;
    for (const glm::dvec3& place_m : places_m) {
      low = glm::min(low, place_m);
      high = glm::max(high, place_m);
    }
    middle_m_ = 0.5 * (low + high);
  }

  void add_cameras() {
    std::vector<std::string> names;
    for (const meshes::GltfCamera& camera : stage_.cameras) names.push_back(camera.name);
    std::size_t chosen = 0;
    if (!choice_.camera.empty()) {
      chosen = static_cast<std::size_t>(std::ranges::find(names, choice_.camera) - names.begin());
      if (chosen == names.size())
        fail(fmt::format("a camera \"{}\"", one_line(choice_.camera)), "none of this name",
             hint_of_names(choice_.camera, names, "leave out --camera: the file has no camera"));
    }
    for (std::size_t i = 0; i < stage_.cameras.size(); ++i) {
      const meshes::GltfCamera& camera = stage_.cameras[i];
      if (i == chosen) {
        set_camera(camera);
      } else {
        imported_.scene.bookmarks.push_back(
            {.name = camera.name, .camera = camera_at(to_world_[camera.node].front(), camera)});
      }
    }
  }

  void set_camera(const meshes::GltfCamera& camera) {
    std::vector<Camera> cameras;
    for (const glm::dmat4& to_world : to_world_[camera.node]) cameras.push_back(camera_at(to_world, camera));
    Camera& first = imported_.scene.view.camera;
    first = cameras.front();
    const auto move = [&](const char* key, double& constant, auto member, double period = 0.0) {
      set_track({key}, constant, period, [&](std::size_t frame) { return member(cameras[frame]); });
    };
    move("camera.x_m", first.eye_m.x, [](const Camera& at) { return at.eye_m.x; });
    move("camera.y_m", first.eye_m.y, [](const Camera& at) { return at.eye_m.y; });
    move("camera.z_m", first.eye_m.z, [](const Camera& at) { return at.eye_m.z; });
    constexpr double turn = 2.0 * std::numbers::pi;
    move(
        "camera.yaw_deg", first.yaw_rad, [](const Camera& at) { return at.yaw_rad; }, turn);
    move("camera.pitch_deg", first.pitch_rad, [](const Camera& at) { return at.pitch_rad; });
    move(
        "camera.roll_deg", first.roll_rad, [](const Camera& at) { return at.roll_rad; }, turn);
  }

  void add_light(const meshes::GltfLight& light) {
    const ElementIndex element{imported_.scene.lights.size(), 0};
    LightScene& made = imported_.scene.lights.emplace_back();
    made.name = unused_name(light.name.empty() ? "light" : light.name);
    made.colour = glm::clamp(light.colour, 0.0, 1.0);
    const std::vector<glm::dmat4>& to_world = to_world_[light.node];
    double lx = light.intensity;
    if (light.is_directional) {
      // It comes from where its +z axis points.
      const auto to_light = [&](std::size_t frame) { return axis_of(to_world[frame], 2); };
      constexpr double turn = 2.0 * std::numbers::pi;
      set_track({"light.azimuth_deg", element}, made.azimuth_rad, turn,
                [&](std::size_t frame) { return std::atan2(to_light(frame).x, -to_light(frame).z); });
      set_track({"light.elevation_deg", element}, made.elevation_rad, 0.0,
                [&](std::size_t frame) { return std::asin(std::clamp(to_light(frame).y, -1.0, 1.0)); });
    } else {
      made.kind = LightKind::place;
      constexpr std::array<const char*, 3> keys{"light.x_m", "light.y_m", "light.z_m"};
      for (int axis = 0; axis < 3; ++axis) {
        set_track({keys[static_cast<std::size_t>(axis)], element}, made.place_m[axis], 0.0,
                  [&](std::size_t frame) { return to_world[frame][3][axis]; });
      }
      constexpr double nearest_m = 1e-3;
      lx /= std::pow(std::max(glm::distance(made.place_m, middle_m_), nearest_m), 2);
    }
    if (lx > 1e3 * most_klx) leave_out_light_beyond();
    made.illuminance_klx = std::min(1e-3 * lx, most_klx);
  }

  void leave_out_light_beyond() {
    constexpr const char* what = "illuminances of lights above 1000 klx";
    const auto found = std::ranges::find(imported_.left_out, what, &LeftOut::what);
    if (found == imported_.left_out.end()) {
      imported_.left_out.push_back({what, 1});
    } else {
      ++found->count;
    }
  }

  /// One that no other light has, and not the sun's.
  std::string unused_name(const std::string& stem) {
    std::string name = stem;
    for (int i = 2; name == "sun" || !light_names_.insert(name).second; ++i)
      name = fmt::format("{} {}", stem, i);
    return name;
  }

  template <class ValueAtFrame>
  void set_track(const ValueKey& key, double& constant, double period, const ValueAtFrame& value_at_frame) {
    std::vector<Keyframe> keys;
    for (std::size_t frame = 0; frame < times_s_.size(); ++frame) {
      double value = value_at_frame(frame);
      // Angles go on from where they were, so that those on a line are seen to be.
      if (period > 0.0 && !keys.empty()) value += period * std::round((keys.back().value - value) / period);
      keys.push_back({times_s_[frame], value});
    }
    keys = without_straight_ones(keys, period);
    for (Keyframe& each : keys) {
      if (period > 0.0) each.value = std::remainder(each.value, period);
      each.value += 0.0;  // so that no zero has a sign
    }
    constant = keys.front().value;
    if (keys.size() > 1)
      imported_.scene.tracks[key] = {
          .keys = std::move(keys), .interpolation = Interpolation::linear, .period = period};
  }

  /// Throws Error where the scene's file could not be read back.
  void require_readable() const {
    try {
      parse_scene(scene_text(imported_.scene, ""), "", "");
    } catch (const Error& error) {
      fail("values that a scene can have", fmt::format("others: {}", error.what()),
           "change them in the program that the file is from, and export it again");
    }
  }

  std::filesystem::path file_;
  GltfChoice choice_;
  Trust trust_;
  meshes::GltfStage stage_;
  std::vector<double> times_s_;                              // of frames
  std::map<std::size_t, std::vector<glm::dmat4>> to_world_;  // of nodes with a camera or a light, [frames]
  glm::dvec3 middle_m_{0.0};                                 // of the meshes at the start
  std::set<std::string> light_names_;
  ImportedScene imported_;
};

}  // namespace

ImportedScene import_gltf(const std::filesystem::path& file, const GltfChoice& choice, Trust trust) {
  return GltfImporter(file, choice, trust).import();
}

}  // namespace offing::scene
