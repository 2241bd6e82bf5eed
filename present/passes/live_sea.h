#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/base/error.h"
#include "host/scene/model/scene.h"
#include "host/world/world.h"
#include "present/editing/cloud_builder.h"
#include "present/gl/gl_context.h"
#include "present/output/recorder.h"
#include "present/passes/frame.h"
#include "present/passes/lake_filler.h"
#include "present/passes/sky/light_meter.h"
#include "present/passes/world_opening.h"

namespace offing::present {

/// What a picture is one of.
enum class PictureKind {
  moving,  ///< of many, each of which may keep something of those before it
  still,   ///< one by itself, as SceneImages draws it
};

struct LiveSeaSettings {
  std::string device;  ///< selector of ocl::select_device
  FrameSettings frame;
  std::optional<FrameSettings> still = {};  ///< of pictures in PictureKind::still; absent: as all others
  const CancelToken* cancel = nullptr;      ///< of making whole worlds; outlives the sea
  std::optional<FirstView> first = {};      ///< of the first scene; absent: its start
  /// Called some twenty times a second while a scene is opened, by the thread that waits for it.
  std::function<void(const OpeningStep&)> watch = {};
};

/// A part of an edited scene that cannot be made.
class UnmadePart : public Error {
 public:
  using Asked = std::function<bool(const scene::Scene& before, const scene::Scene& after)>;

  UnmadePart(const Error& error, Asked is_asked) : Error(error), is_asked_(std::move(is_asked)) {}

  /// Whether the edit from one scene to the next asked for it.
  bool is_asked(const scene::Scene& before, const scene::Scene& after) const {
    return is_asked_(before, after);
  }

 private:
  Asked is_asked_;
};

/// A scene's world and the passes that draw it, both of which can be exchanged while they are shown. Whatever
/// throws leaves everything as it was, unless the device cannot even make again what it had.
class LiveSea {
 public:
  /// Throws what making a world and its pictures throws.
  LiveSea(const GlContext& context, const LiveSeaSettings& settings, const scene::Scene& scene);

  /// Shows another scene as a fresh start with it would, on the same device: nothing of the one before goes
  /// on. Throws what making a world throws, Error(cancelled) where the token says so.
  void open(const scene::Scene& scene);
  /// Changes the scene, making anew only what differs. Clouds and lakes that differ are made in the
  /// background. Until then the previous ones are shown, but no lakes if the ground has changed.
  void begin_edit(const scene::Scene& scene, Haste haste);
  /// Shows clouds and lakes that have been made since; whether there were any. Throws UnmadePart where that
  /// failed: the world and its scene are as they were, but wanted() is not shown then.
  bool take_made();
  /// begin_edit() and take_made() once all is made.
  void edit(const scene::Scene& scene);
  /// Whether clouds or lakes are being made.
  bool is_making() const { return lakes_.is_busy() || clouds_progress(); }
  /// How far clouds are that are being made; nothing when none are.
  std::optional<world::CloudProgress> clouds_progress() const { return builder_->progress(); }
  /// Whether wakes of the last picture have not come as far as its time (Quality::most_wake_steps).
  bool is_behind() const { return world_->wakes() != nullptr && world_->wakes()->is_behind(); }
  /// How long the last edit took.
  double edit_s() const { return edit_s_; }
  /// What there is to say about the scene, scene::steepness_warning(); logged when it comes up.
  const std::string& warning() const { return warning_; }
  /// What values that the scene leaves open are, by their keys.
  std::map<std::string_view, double> computed_values() const;
  /// What is shown.
  const scene::Scene& scene() const { return scene_; }
  /// That of the last edit that began: with clouds and lakes that are still being made.
  const scene::Scene& wanted() const { return wanted_; }
  /// Compiles kernels and shaders again, from where they come from (ocl::Program, shader_file()).
  void reload();

  /// Height of the last picture's water or of the ground at a place, whichever is higher, above the water's
  /// mean, m; -inf where there is neither. Throws Error(bad_input) where no point of the water may be
  /// (farthest_point_m).
  double surface_height_m(double x_m, double z_m);
  double sea_level_m() const { return world_->sea_level_m(); }
  /// nullptr without ground.
  world::WorldTerrain* terrain() { return world_->terrain(); }
  /// nullptr without clouds.
  const world::WorldClouds* clouds() const { return std::as_const(*world_).clouds(); }
  /// nullptr without floating bodies.
  const world::WorldBodies* bodies() const { return std::as_const(*world_).bodies(); }
  /// As the last picture shows them.
  const std::vector<world::WorldMesh>& meshes() const { return std::as_const(*world_).meshes(); }

  /// Sun, air and exposure are those of the scene at that time. False where the request is not wanted any
  /// more: the last picture is the one before then. Throws what scene::view_at() throws.
  bool draw(FrameRequest request, PictureKind kind = PictureKind::moving);
  /// Another one for each change of what it shows at a time.
  std::uint64_t revision() const { return revision_; }
  /// The last picture is the next frame of a recording.
  void record(Recorder& recorder) const { recorder.write(*frame_, request_.time_s, request_.exposure); }
  /// The last picture, into a file (image_file.h).
  void write(const std::filesystem::path& path, Existing existing) const;

  Frame& frame() { return *frame_; }
  const ocl::DeviceInfo& device() const { return device_.info(); }

 private:
  /// Replaces all by a scene's.
  void make(const scene::Scene& scene, std::optional<FirstView> view);
  /// What is compiled or allocated at first use.
  void try_out(world::World& world, const FrameRequest& request) const;
  void simulate(const FrameRequest& request);
  /// Changes the world, or leaves it as it was.
  void change(const std::function<void()>& work);
  void show_clouds(BuiltClouds built);
  void fill_lakes(Haste haste);
  bool take_lakes();
  UnmadePart unmade_lakes(const Error& error) const;
  std::unique_ptr<Frame> new_frame(const scene::Scene& scene) const;
  /// What was written where has been checked: edits are not to be warned of as if they were in the file.
  void take_scene(scene::Scene scene, std::optional<scene::Scene> wanted = {});
  void warn();

  const GlContext& context_;
  FrameSettings settings_, still_settings_;
  const CancelToken* cancel_;
  std::function<void(const OpeningStep&)> watch_;
  ocl::Device device_;
  scene::Scene scene_, wanted_;
  scene::Scene next_;  // as scene_ but within an edit: edits copy what they change and no more
  std::unique_ptr<CloudBuilder> builder_;
  LakeFiller lakes_;
  std::vector<scene::LakeScene> filled_lakes_;  // that were shown last, be it on other ground
  std::string warning_;
  std::unique_ptr<world::World> world_;
  std::unique_ptr<Frame> frame_;
  LightMeter light_meter_;
  FrameRequest request_;  // of the last picture
  std::uint64_t revision_ = 0;
  double edit_s_ = 0.0;
  bool is_drawn_ = false;  // since the scene was opened
};

}  // namespace offing::present
