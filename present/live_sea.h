#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "host/scene/ocean_scene.h"
#include "host/world/world.h"
#include "present/frame.h"
#include "present/gl_context.h"

namespace offing::present {

struct LiveSeaSettings {
  std::string device;  ///< selector of ocl::select_device
  FrameSettings frame;
};

/// What to show of a sea: when, from where, and how.
struct SeaView {
  double time_s = 0.0;
  Camera camera;
  double exposure_ev = 0.0;
  DebugView debug = DebugView::none;
  Fill fill = Fill::solid;
};

/// A scene's world and the passes that draw it, both of which can be exchanged while they are shown. Whatever
/// throws leaves everything as it was.
class LiveSea {
 public:
  /// Throws what making a world and its pictures throws.
  LiveSea(const GlContext& context, const LiveSeaSettings& settings, const scene::OceanScene& scene);

  /// Makes the world of another scene.
  void make(const scene::OceanScene& scene);
  /// Turns the sun to where the scene has it, without making the world anew.
  void turn_sun(const scene::ViewScene& view);
  /// Compiles kernels and shaders again, from where they come from (ocl::Program, shader_file()).
  void reload();

  void draw(const SeaView& view);
  /// The last picture, into a file (picture_file.h).
  void write(const std::filesystem::path& path) const;

  Frame& frame() { return *frame_; }
  const ocl::DeviceInfo& device() const { return device_.info(); }

 private:
  std::unique_ptr<world::World> world_of(const scene::OceanScene& scene) const;
  void simulate(const SeaView& view);

  const GlContext& context_;
  FrameSettings settings_;
  ocl::Device device_;
  scene::OceanScene scene_;
  std::unique_ptr<world::World> world_;
  std::unique_ptr<Frame> frame_;
  SeaView view_;  // of the last picture
  double exposure_ = 1.0;
};

}  // namespace offing::present
