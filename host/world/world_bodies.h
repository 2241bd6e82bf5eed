#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "host/bodies/body_pose.h"
#include "host/bodies/floating_bodies.h"
#include "host/bodies/hull_map.h"
#include "host/bodies/hull_press.h"
#include "host/highlights/search/lighting.h"
#include "host/ocean/spectrum/sea_spectrum.h"
#include "host/ocean/spectrum/wind.h"
#include "host/ocean/surface/gerstner_waves.h"
#include "host/ocean/surface/ocean.h"
#include "host/ocl/buffer.h"
#include "host/ocl/event.h"
#include "kernels/shared/bodies.h"

namespace offing::world {

/// Where floating bodies have been since their start, in host memory: what a device has computed is fetched
/// without waiting for it. Poses between are interpolated.
class BodyPath {
 public:
  BodyPath() = default;
  BodyPath(const BodyPath&) = delete;
  BodyPath& operator=(const BodyPath&) = delete;
  ~BodyPath();

  /// Begins anew with these poses, further ones being `step_s` apart.
  void begin(double time_s, double step_s, const std::vector<bodies::BodyPose>& starts);
  /// Begins to fetch the states of the next step, [bodies], and if they are given the reports on it.
  void add(const ocl::Buffer<BodyState>& states, const ocl::Buffer<BodyReport>* reports = nullptr);

  double begin_s() const { return begin_s_; }
  double end_s() const { return begin_s_ + step_s_ * static_cast<double>(rows_.size() - 1); }
  /// Waits for the device where it has not come so far; the first pose before the start, the last one after
  /// the end.
  bodies::BodyPose at(std::size_t body, double time_s) const;
  /// The same of reports; 0 where none were given.
  BodyReport report(std::size_t body, double time_s) const;

 private:
  struct Row {
    std::vector<BodyState> states;
    std::vector<BodyReport> reports;
    ocl::Event fetched;
  };
  const Row& fetched_row(std::size_t row) const;
  /// A row's number, and the share of the way to the next one.
  std::pair<std::size_t, double> place_of(double time_s) const;

  double begin_s_ = 0.0, step_s_ = 1.0;
  std::deque<Row> rows_;  // the device writes into them: they stay where they are
  mutable std::size_t fetched_ = 0;
};

/// A floating body of a world, and the mesh that is drawn where it is.
struct BodySettings {
  bodies::FloatingBody body;  ///< its start is that of the run-up
  /// The whole mesh as seen from below and above, in the axes of the body's hull.
  std::shared_ptr<const bodies::HullMap> map;
  std::size_t mesh = 0;                    ///< which of the world's
  highlights::RigidMotion mesh_in_hull{};  ///< from the mesh's axes to those of the body's hull
  std::vector<std::size_t> aboard;         ///< further meshes, whose own motions are in the axes of the hull
  /// What drives it in the sub-step that begins at a time, which is before `start_s` in the run-up.
  std::function<BodyDrive(double time_s, double start_s)> drive;
};

/// The water that bodies ask: the sea of a world, without its wakes.
struct BodySea {
  ocean::SeaSpectrum spectrum;
  ocean::OceanParameters ocean;
  ocean::Wind wind = {};
  std::shared_ptr<const ocean::Shoals> shoals = {};
  double level_m = 0.0;  ///< heights are from it; pose() and motion_of_hull() give those of the world
};

class WorldBodies;

/// Bodies of an earlier simulation that go on in another one.
struct BodiesBefore {
  const WorldBodies* bodies = nullptr;              ///< none: all begin anew
  std::vector<std::optional<std::size_t>> numbers;  ///< of each new body its number there; none: begins anew
};

/// The floating bodies of a world. They are simulated from a start on, and before that for a run-up in which
/// they come to lie in the water as they do; a world that is shown at a later time goes all the way there.
/// What is enqueued goes a little beyond the time that is asked for, so that poses have come when they are
/// drawn. Bodies feel the waves of cascades and Gerstner waves that are no shorter than the shortest of them,
/// at the times of their own sub-steps; not the wakes, which are their own for the most part.
class WorldBodies {
 public:
  /// Bodies that were there before, with the same hull and load, move up to the start as they did then, and
  /// go on from there. Throws what FloatingBodies and Ocean throw.
  WorldBodies(const ocl::Device& device, std::vector<BodySettings> settings, const BodySea& sea,
              double run_up_s, double start_s, const BodiesBefore& before = {});

  /// Another sea from the time on that has been simulated.
  void set_sea(const BodySea& sea);
  /// The same for its Gerstner waves alone. Throws what Ocean::set_gerstner_waves() throws.
  void set_gerstner_waves(const ocean::GerstnerSea& gerstner_waves);
  /// The same for its level alone.
  void set_level(double level_m) { level_m_ = level_m; }
  /// The same for its shoals alone.
  void set_shoals(std::shared_ptr<const ocean::Shoals> shoals);

  /// Whether forces of all times are kept, from the next reach() on: 6.7 kB a second of each body.
  void keep_forces(bool keep) { keeps_forces_ = keep; }
  /// Simulates up to this time, and a little further; from the start of a world on where it is before that
  /// of these bodies. Throws Error(bad_input) for a leap of more than two hours.
  void reach(double time_s);

  std::size_t size() const { return settings_.size(); }
  const std::vector<BodySettings>& settings() const { return settings_; }
  /// Which of the world's meshes are where it is.
  void set_meshes(std::size_t body, std::size_t mesh, std::vector<std::size_t> aboard) {
    settings_[body].mesh = mesh;
    settings_[body].aboard = std::move(aboard);
  }
  double start_s() const { return start_s_; }
  /// The time at which the run-up begins.
  double begin_s() const { return path_->begin_s(); }
  /// At any time up to that of the last reach().
  bodies::BodyPose pose(std::size_t body, double time_s) const;
  /// What acts on a body at any time up to that of the last reach(), between sub-steps 1/30 s apart; 0 where
  /// forces were not kept.
  BodyReport forces(std::size_t body, double time_s) const { return path_->report(body, time_s); }
  /// What acted on the bodies in the last sub-step that was simulated, [size()], which ended at
  /// reported_s(): a little after the time of the last reach() that went further; waits.
  std::vector<BodyReport> read_reports() const { return bodies_.read_reports(); }
  double reported_s() const { return bodies_.stepped_to_s(); }
  /// Where the axes of a body's hull are at any time up to that of the last reach(). Outlives the view.
  std::function<highlights::RigidMotion(double time_s)> motion_of_hull(std::size_t body) const;
  /// Enqueues what adds the hulls at a time to displaced [n][n] m of a wake window. In the beginning of the
  /// run-up they come to their weight by and by.
  void press(double time_s, const WakeGrid& grid, ocl::Buffer<float>& displaced) const;
  /// Enqueues what adds to [n][n] m/s how fast that depth grows by the motion of the hulls, but for their
  /// turning, in the water around them.
  void add_growth(double time_s, const WakeGrid& grid, ocl::Buffer<float>& growth) const;
  /// Of all hulls, at rest.
  double draught_m() const { return draught_m_; }

 private:
  void reset(double start_s);
  void follow_paths_before();
  double total_draught_m() const;
  bodies::BodyPose pose_on_sea(std::size_t body, double time_s) const { return path_->at(body, time_s); }
  double settled_share(double time_s) const;
  void tell_waves();
  double lost_wave_share(std::size_t body, double time_s) const;
  void ask_sea(double time_s, const ocl::Buffer<SurfaceQueryPoint>& points, std::size_t count,
               ocl::Buffer<SurfaceQueryShifted>& samples);

  ocl::Device device_;
  std::vector<BodySettings> settings_;
  bool keeps_forces_ = false;
  double run_up_s_, start_s_ = 0.0, draught_m_ = 0.0, level_m_ = 0.0;
  bodies::FloatingBodies bodies_;
  std::vector<bodies::HullPresser> pressers_;
  ocean::Ocean sea_;
  std::shared_ptr<const ocean::Shoals> shoals_;
  ocean::WaterQuery query_;
  std::shared_ptr<BodyPath> path_;
  std::shared_ptr<const BodyPath> path_before_;             // of bodies that were there before the start
  std::vector<std::optional<std::size_t>> numbers_before_;  // in that path, [size()]
};

}  // namespace offing::world
