#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include <glm/vec2.hpp>

#include "host/base/sea/modal_sea.h"
#include "host/bodies/floating_body.h"
#include "host/ocl/buffer.h"
#include "host/ocl/device.h"
#include "host/ocl/event.h"
#include "host/ocl/kernel.h"
#include "kernels/shared/bodies.h"
#include "kernels/shared/query_params.h"

namespace offing::bodies {

/// The water that bodies float on, and how finely they move.
struct BodyWaterParameters {
  double density_kgpm3 = 1025.0;
  double gravity_mps2 = 9.81;
  double viscosity_m2ps = 1.19e-6;  ///< kinematic, of sea water at 15 degrees
  double air_density_kgpm3 = 1.225;
  glm::dvec2 wind_mps{0.0};  ///< of the air 10 m above it, along x and z
};

/// Rigid bodies that float by the pressure on the submerged parts of their faces (O14's bodies): hydrostatic
/// below the surface of the moment, which stands for the pressure of waves that are longer than the hull;
/// drag and damping as bodies/body_advance.cl says. A water surface answers for their vertices every
/// `steps_a_question` sub-steps, and is moved on between.
///
/// A simulation with history: reset(), then advance_to() in sub-steps of 1/120 s. States at the times of
/// sub-steps do not depend on which times were asked for, and are the same bits on the same device. Between
/// sub-steps poses are interpolated. Bodies do not touch one another.
///
/// Not safe for use from several threads at once.
class FloatingBodies {
 public:
  static constexpr double steps_per_s = 120.0;
  static constexpr int steps_a_question = 4;

  /// Enqueues the answers for the first `count` points at a time: height, slopes, velocity and shift of the
  /// surface. ocean::Ocean::sample() has this form.
  using WaterSurface = std::function<void(double time_s, const ocl::Buffer<SurfaceQueryPoint>& points,
                                          std::size_t count, ocl::Buffer<SurfaceQueryShifted>& samples)>;
  /// What drives a body in the sub-step that begins at a time.
  using Drive = std::function<BodyDrive(std::size_t body, double time_s)>;

  /// Throws Error(bad_input) for bodies (require_valid()) or water out of range, and Error(bad_usage) without
  /// bodies.
  FloatingBodies(const ocl::Device& device, std::vector<FloatingBody> bodies,
                 const BodyWaterParameters& water = {});
  FloatingBodies(const FloatingBodies&) = delete;
  FloatingBodies& operator=(const FloatingBodies&) = delete;
  ~FloatingBodies();

  std::size_t size() const { return bodies_.size(); }
  const std::vector<FloatingBody>& bodies() const { return bodies_; }

  /// Whether a body has hydrodynamic data, so that set_waves() tells it something.
  bool feels_waves() const;
  /// The waves of the water surface from now on, as sums: bodies with hydrodynamic data have the excitation
  /// of the data in them, those that lead (leading_modes()). None at first.
  void set_waves(const ModalSea& sea);

  /// The wind from now on, as BodyWaterParameters has it.
  void set_wind(const glm::dvec2& wind_mps);

  /// Puts all bodies to their starts at this time.
  void reset(double time_s);
  /// Puts a body into this pose at stepped_to_s(). Forces that remember its velocities keep those it had.
  void put(std::size_t body, const BodyPose& pose);
  /// Enqueues the sub-steps up to this time. Throws Error(bad_usage) for a time before the last reset or
  /// before the sub-steps that are kept: those of the last question.
  void advance_to(double time_s, const WaterSurface& water, const Drive& drive = {});

  double time_s() const { return time_s_; }
  /// The time of the last sub-step that was enqueued: time_s() or later.
  double stepped_to_s() const;
  /// Sub-steps since the reset.
  std::int64_t steps() const { return questions_ * steps_a_question; }

  /// States of the last sub-steps on the device, [steps_a_question][bodies]; the last row is of
  /// stepped_to_s().
  const ocl::Buffer<BodyState>& path() const { return path_; }
  /// States at stepped_to_s() on the device, [bodies].
  const ocl::Buffer<BodyState>& latest() const { return now_; }
  /// Poses at time_s(); waits.
  std::vector<BodyPose> read_poses();
  /// Poses of the last advance_to() whose states have been fetched by now, at that one's time: those before
  /// the last advance_to(), so that no one waits for the device. The starts after a reset().
  const std::vector<BodyPose>& late_poses() const { return late_poses_; }
  /// What acted on bodies in the last sub-step, on the device, [bodies].
  const ocl::Buffer<BodyReport>& reports() const { return reports_; }
  /// The same; waits.
  std::vector<BodyReport> read_reports() const { return reports_.read(); }

  /// A mesh point of a body in the world.
  static glm::dvec3 world_point(const FloatingBody& body, const BodyPose& pose,
                                const glm::dvec3& mesh_point_m) {
    return pose.mass_centre_m + pose.turn * (mesh_point_m - body.mass_centre_m);
  }

 private:
  // What drives the sub-steps after a question, on its way to the device.
  struct Drives {
    std::vector<BodyDrive> values;
    ocl::Event sent;
  };
  // States on their way to the host, and the time that they were asked for.
  struct Fetch {
    std::vector<BodyState> before, path;
    ocl::Event done;
    std::int64_t questions = -1;
    double time_s = 0.0;
  };

  void upload();
  std::vector<BodyDrive> drives_from(const Drive& drive) const;
  void send_drives(const Drive& drive);
  void ask_and_step(const WaterSurface& water, const Drive& drive);
  void fetch();
  std::vector<BodyPose> poses_of(const Fetch& fetch) const;
  double question_s(std::int64_t question) const;
  void upload_waves();

  ocl::Device device_;
  std::vector<FloatingBody> bodies_;
  std::vector<BodyShape> host_shapes_;
  std::vector<SeaMode> modes_;
  BodyWater water_;
  std::size_t group_;  // work-items that share the faces of a body
  ocl::Kernel points_kernel_, waves_kernel_, advance_kernel_;
  std::size_t vertices_ = 0;
  ocl::Buffer<BodyShape> shapes_;
  ocl::Buffer<float> hull_;
  ocl::Buffer<float> memory_, velocities_;  // added mass and retardation; velocities that bodies have had
  ocl::Buffer<BodyMooring> moorings_;
  ocl::Buffer<float> wave_tables_, excitation_;  // what waves do to hulls; to bodies, after a question
  ocl::Buffer<BodyWave> waves_;
  ocl::Buffer<std::uint32_t> owners_, faces_;
  ocl::Buffer<SurfaceQueryPoint> points_;
  ocl::Buffer<SurfaceQueryShifted> samples_;
  ocl::Buffer<BodyDrive> drives_;
  ocl::Buffer<BodyState> now_, before_;  // states at the next question and at the last one
  ocl::Buffer<BodyState> path_;          // those between
  ocl::Buffer<BodyReport> reports_;

  double reset_s_ = 0.0, time_s_ = 0.0;
  std::int64_t questions_ = 0;
  std::array<Drives, 8> drives_ahead_;
  std::size_t drives_sent_ = 0;
  std::vector<BodyPose> late_poses_;
  Fetch fetch_;
};

}  // namespace offing::bodies
