#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "host/clouds/particles/particle_order.h"
#include "host/clouds/shape/cloud_parameters.h"
#include "host/ocl/buffer.h"
#include "host/ocl/kernel.h"
#include "host/ocl/program.h"
#include "host/ocl/tuning.h"
#include "kernels/shared/cloud_light_params.h"
#include "kernels/shared/clouds.h"

namespace offing::clouds {

/// Along the axes of the particles, m.
struct CloudBox {
  glm::vec3 low_m, high_m;
};

/// What cells light is worked out in: about as large as particles, for billboards, which show one light each;
/// or smaller, for clouds that are marched.
enum class LightCells { of_billboards, of_marched };
/// Room for the cells of a cloud's grid.
constexpr std::size_t light_grid_cells(LightCells cells) {
  return cells == LightCells::of_marched ? CLOUD_MOST_CELLS : CLOUD_MOST_CELLS / 2;
}
/// Cells of a heap for billboards, and of all clouds of a sky together where they are marched: more would
/// take too long.
constexpr std::size_t billboard_heap_cells = 4096, marched_sky_cells = 65536;
/// Whether so many clouds can have smaller cells, at least twice as many.
constexpr bool have_marched_cells(std::size_t clouds) {
  return 2 * clouds * billboard_heap_cells <= marched_sky_cells;
}

/// On the device, of the last relight() by the calibrated model: what the headers of
/// kernels/clouds/light_*.cl say.
struct LightFields {
  const ocl::Buffer<CloudGrid>& grids;
  const ocl::Buffer<CloudScattering>& looks;
  const ocl::Buffer<CloudLightParams>& lights;
  const ocl::Buffer<float>&phases, &absorption, &entries;
  const ocl::Buffer<std::array<float, 4>>&glow, &drift;
  LightCells cells;
  std::size_t clouds;
  int suns, channels;
  glm::dvec3 first_sun;  // unit, toward it; up where there is none
};

/// Whether all particles have the albedo of their cloud's look, or some another.
enum class ParticleAlbedo { of_look, own };

/// Light on particles and toward the eye (C10 to C12), on the device. relight() when the suns, the sky or the
/// particles change; see() when the eye moves. Clouds light and shade themselves, each in a grid of its own,
/// and take the suns' light from those behind them. What they send each other comes with their illumination.
///
/// LightModel::calibrated keeps energy: direct light in the delta-scaled medium with its aureole
/// (host/clouds/light/phase_function.h) and diffusion of what is scattered more often
/// (kernels/clouds/light_diffuse.cl). A cloud takes 0.7 MB of the device, and 0.1 MB more with each
/// sun after the first; each of up to 16 clouds takes 5 MB more to work with. In smaller cells all are twice
/// as large.
class ParticleLight {
 public:
  explicit ParticleLight(const ocl::Device& device, LightCells cells = LightCells::of_billboards);
  ParticleLight(const ParticleLight&) = delete;  // steps know where it is
  ParticleLight& operator=(const ParticleLight&) = delete;

  /// Queues the light on the first `count` particles, those of a cloud side by side, clouds in rising order,
  /// each below looks.size(). lights: one a look, or one for all. Keeps a reference to the particles. Throws
  /// Error(bad_usage) if there are fewer particles or more than CLOUD_SUNS suns; Error(bad_input) as
  /// PhaseFunction does, and for light that is not finite or directions that are not of unit length within
  /// 1e-3.
  void relight(const ocl::Buffer<CloudParticle>& particles, std::uint32_t count,
               std::span<const CloudIllumination> lights, std::span<const CloudLook> looks,
               LightModel model = LightModel::calibrated, ParticleAlbedo albedo = ParticleAlbedo::of_look);
  void relight(const ocl::Buffer<CloudParticle>& particles, std::uint32_t count,
               const CloudIllumination& light, std::span<const CloudLook> looks,
               LightModel model = LightModel::calibrated, ParticleAlbedo albedo = ParticleAlbedo::of_look) {
    relight(particles, count, std::span(&light, 1), looks, model, albedo);
  }

  /// The same in steps: each relight_further() queues one and returns whether any is left. Call nothing but
  /// that, relight() or start_relight() until none is.
  void start_relight(const ocl::Buffer<CloudParticle>& particles, std::uint32_t count,
                     std::span<const CloudIllumination> lights, std::span<const CloudLook> looks,
                     LightModel model, ParticleAlbedo albedo);
  bool relight_further();
  std::size_t steps_left() const { return steps_.size() - steps_done_; }

  /// Waits for the box around the particles of the last relight(); nothing where there are none.
  std::optional<CloudBox> box() const;

  /// Valid until the next relight().
  LightFields fields() const {
    return {grids_,   looks_,    lights_,    phases_, absorption_,
            entries_, glow_,     drift_,     cells_,  known_looks_.size(),
            suns_,    channels_, first_sun()};
  }

  /// One of several parts of all particles, about as many in each.
  struct Part {
    std::uint32_t index, of;
  };

  /// Queues what an eye at this place, in the particles' axes, sees of each, or of each of a part: sprites
  /// [count].
  void see(const glm::vec3& eye_m, ocl::Buffer<CloudSprite>& sprites, Part part = {0, 1});

 private:
  using Float4 = std::array<float, 4>;

  glm::dvec3 first_sun() const;
  void set_lights(std::span<const CloudIllumination> lights, std::size_t clouds);
  void set_looks(std::span<const CloudLook> looks);
  void reserve(std::size_t clouds);
  void diffuse(std::size_t clouds);
  void scatter_often(std::size_t first, std::size_t number);
  void add_step(std::function<void()> step) { steps_.push_back(std::move(step)); }
  void carry_along(std::span<const CloudIllumination> lights, std::size_t clouds);

  ocl::Device device_;
  LightCells cells_;
  ocl::KernelTuning density_tuning_, cell_tuning_, group_tuning_, scatter_tuning_;
  ocl::Kernel bounds_kernel_, density_kernel_, entry_kernel_, beam_kernel_, source_kernel_, coarsen_kernel_,
      emission_kernel_, sweep_kernel_, gather_kernel_, diffuse_kernel_, glow_kernel_, scatter_kernel_,
      recurrence_kernel_, first_order_kernel_;
  std::vector<std::function<void()>> steps_;  // of the last relight
  std::size_t steps_done_ = 0;
  const ocl::Buffer<CloudParticle>* particles_ = nullptr;
  std::uint32_t count_ = 0;
  std::vector<CloudLightParams> packed_lights_;  // as lights_ has them
  int suns_ = 0, channels_ = 1;                  // kernels/clouds/light_grid.clh
  LightModel model_ = LightModel::calibrated;
  ParticleOrder order_;
  ocl::Buffer<std::int32_t> recurrence_map_;
  ocl::Buffer<float> reached_;
  std::vector<CloudLook> known_looks_;
  ocl::Buffer<CloudGrid> grids_;
  ocl::Buffer<CloudScattering> looks_;
  ocl::Buffer<CloudLightParams> lights_;
  ocl::Buffer<float> phases_, entries_, beams_, medium_, absorption_, faces_, sources_, fluence_, planes_;
  ocl::Buffer<Float4> glow_, drift_, moments_, emission_, radiances_;
};

}  // namespace offing::clouds
