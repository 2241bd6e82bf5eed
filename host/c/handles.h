#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/base/camera.h"
#include "host/base/wave_spectrum.h"
#include "host/c/call.h"
#include "host/clouds/image/cloud_image.h"
#include "host/clouds/reference/scattering_medium.h"
#include "host/io/height_maps/read_height_map.h"
#include "host/io/meshes/mesh_file.h"
#include "host/ocl/device.h"
#include "host/scene/model/scene.h"
#include "host/terrain/analysis/viewshed.h"
#include "host/terrain/field/height_field.h"
#include "host/terrain/field/terrain_posts.h"
#include "host/terrain/lakes/lake.h"
#include "host/world/world.h"

/// What the handles of offing.h are.

struct OffingDevice {
  offing::ocl::Device device;
};

/// Threads may share it: a call works on a copy, which holds either the spectrum from before a change or the
/// one after it.
struct OffingScene {
  explicit OffingScene(offing::scene::Scene of) : scene_(std::move(of)) {}

  offing::scene::Scene copy() const {
    const std::scoped_lock lock(mutex_);
    return scene_;
  }
  void set_spectrum(std::shared_ptr<const offing::WaveSpectrum> spectrum) {
    const std::scoped_lock lock(mutex_);
    scene_.ocean.spectrum_data = std::move(spectrum);
    scene_.ocean.spectrum_file = "the spectrum of the program";
    scene_.ocean.is_given = true;
  }

 private:
  mutable std::mutex mutex_;
  offing::scene::Scene scene_;
};

/// Stays as it was made, so that threads may share it.
struct OffingMesh {
  offing::TriangleMesh mesh;
  std::string format;  // of the file
};

struct OffingWorld : offing::c::OneAtATime {
  OffingWorld(const offing::scene::Scene& of, const offing::ocl::Device& device,
              const offing::world::WorldParameters& parameters)
      : scene(of), world(device, parameters) {}

  /// The extinction of the particles of clouds at a time; none where they have none.
  struct CloudExtinction {
    double time_s = 0.0, cell_m = 0.0;
    std::optional<offing::clouds::VolumeMedium> medium;
  };

  offing::scene::Scene scene;
  offing::world::World world;
  offing::Camera camera;  // of the scene, at the last frame
  // Once asked for.
  std::optional<offing::clouds::CloudImage> cloud_image;
  std::optional<CloudExtinction> cloud_extinction;
};

namespace offing::c {

/// A lake, what was asked for, and its outline as values of the interface.
struct FilledLake {
  double x_m = 0.0, z_m = 0.0;
  std::optional<double> level_m;
  terrain::Lake lake;
  std::vector<double> outline_m;
};

}  // namespace offing::c

struct OffingTerrain : offing::c::OneAtATime {
  OffingTerrain(const offing::ocl::Device& on, offing::HeightMapFile of)
      : device(on),
        file(std::move(of)),
        field(device, offing::terrain::post_grid(file.map), file.map.heights_m),
        posts(offing::terrain::posts_of(file.map)) {}

  std::size_t post_count() const { return file.map.heights_m.size(); }

  offing::ocl::Device device;
  offing::HeightMapFile file;
  offing::terrain::HeightField field;
  offing::terrain::TerrainPosts posts;
  std::optional<offing::terrain::Viewshed> viewshed;  // once asked for
  // The last one: callers ask for its size first.
  std::optional<offing::c::FilledLake> lake;
};
