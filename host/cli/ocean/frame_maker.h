#pragma once

#include <optional>
#include <span>
#include <vector>

#include "host/cli/ocean/bake_settings.h"
#include "host/cli/ocean/wake_history.h"
#include "host/io/meshes/grid_mesh.h"
#include "host/ocean/query/gerstner_instant.h"
#include "host/ocean/surface/gerstner_surface.h"
#include "host/ocean/surface/ocean.h"
#include "host/ocl/device.h"
#include "host/scene/prepare/sea.h"

/// Makes the frames that are baked: the fields of a sea at each time, in host memory.
namespace offing::cli {

/// Unit normals, each [n][n].
struct NormalFields {
  std::vector<float> x, y, z;
};

/// One frame in host memory, as far as the settings ask for it.
struct BakedFrame {
  struct CascadeFields {
    ocean::SurfaceFields surface;
    std::vector<float> foam;         ///< [n][n], or empty
    ocean::VelocityFields velocity;  ///< at the settings' depth, or empty
    NormalFields normal;             ///< of the displaced surface of these fields alone, or empty
  };
  /// A wake window: of its fields height is that of displacement, and the rate of height that of velocity.
  struct Wake {
    double origin_x_m = 0.0, origin_z_m = 0.0, cell_m = 0.0;
    CascadeFields fields;
  };
  int number = 0;
  double time_s = 0.0;
  std::vector<CascadeFields> cascades;
  std::vector<Wake> wakes;
  /// The first cascade with the Gerstner waves, where they are to be included (GerstnerLayer).
  std::optional<CascadeFields> first_with_gerstner = {};
  GridMesh mesh;  ///< all cascades together, and included Gerstner waves, over the longest patch; or empty

  /// What is written of a cascade, or of a wake window, which come after all cascades.
  CascadeFields& written(std::size_t cascade) {
    if (cascade >= cascades.size()) return wakes[cascade - cascades.size()].fields;
    return cascade == 0 && first_with_gerstner ? *first_with_gerstner : cascades[cascade];
  }
};

/// The first cascade of a baked frame with the Gerstner waves of the sea, on one device.
class GerstnerLayer {
 public:
  GerstnerLayer(const ocl::Device& device, const ocean::OceanParameters& sea);

  /// The cascade's fields and the waves added up; Jacobian, eigenvalue and foam are those of all cascades and
  /// waves together, at the labels of this one. Foam and velocity where `spectral` has them. `sea` is at
  /// time_s, before and after, and has the waves.
  BakedFrame::CascadeFields with_waves(const BakedFrame::CascadeFields& spectral, ocean::Ocean& sea,
                                       double time_s, double velocity_depth_m);

 private:
  void add_velocity(ocean::VelocityFields& velocity, const ocean::GerstnerInstant& waves,
                    double depth_m) const;

  ocean::SampleGrid labels_;  // those of the cascade
  ocean::GerstnerSurface surface_;
};

/// Threads that write frames, each a frame at a time.
std::size_t writer_count();

/// What a frame takes of host memory.
std::size_t frame_bytes(const BakeSettings& settings, int size, std::size_t cascades);

/// What a maker's sea takes of its device's memory, to a tenth: waves, maps and past foam. Gerstner waves and
/// meshes take little beside them.
std::size_t sea_bytes(const BakeSettings& settings, const scene::Sea& sea);
/// Throws Error(out_of_memory) where a maker on each of these devices would need more host memory than is
/// free: for all frames that are on their way at once, and for the seas of devices that use the host's
/// memory.
void require_host_room(const BakeSettings& settings, const scene::Sea& sea,
                       std::span<const ocl::DeviceInfo> devices);

/// Simulates frames on one device; confined to one thread.
class FrameMaker {
 public:
  /// Wakes are those of `scene`, where the settings ask for them. Throws what Ocean and WakeHistory throw.
  FrameMaker(const ocl::Device& device, const scene::Sea& sea, const BakeSettings& settings,
             const scene::Scene& scene = {});

  BakedFrame make(int frame);

 private:
  GridMesh make_mesh();
  std::vector<BakedFrame::Wake> make_wakes(int frame);

  const BakeSettings& settings_;
  ocean::Ocean ocean_;
  std::optional<GerstnerLayer> gerstner_;  // where ocean_ has such waves
  std::optional<WakeHistory> wakes_;       // where they are written
  int next_wake_frame_ = 0;
};

}  // namespace offing::cli
