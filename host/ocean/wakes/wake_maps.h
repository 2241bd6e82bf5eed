#pragma once

#include <array>
#include <span>
#include <vector>

#include "host/ocean/surface/sample_grid.h"
#include "host/ocean/wakes/wake_window.h"

namespace offing::ocean {

/// The maps of several wake windows at one time, on the device, as layers of the composed surface.
class WakeMaps {
 public:
  explicit WakeMaps(const ocl::Device& device);

  /// Enqueues the maps of these windows at this time, which is to be within a step of their states, as
  /// WakeWindow::draw() does.
  void at(std::span<WakeWindow> windows, double time_s, const WakeWindow::AddDisplaced& add_displaced = {});

  std::size_t count() const { return layers_.size(); }
  /// [windows] one after the other, each [n][n] float4 of WakeWindow::draw().
  const ocl::Buffer<float>& maps() const { return maps_; }
  /// The same with foam, as WakeWindow::show() has it.
  const ocl::Buffer<float>& shown() const { return shown_; }
  /// Where each window lies; one that says nothing where there is none.
  const ocl::Buffer<WakeLayer>& layers() const { return layers_buffer_; }
  const std::vector<WakeLayer>& layer_values() const { return layers_; }
  /// Where a grid's samples lie in each window.
  std::vector<WakeSamples> samples_of(const SampleGrid& grid) const;

  /// One window in host memory.
  struct Instant {
    WakeLayer layer{};
    double origin_x_m = 0.0, origin_z_m = 0.0, cell_m = 0.0;
    std::vector<float> map;  ///< [n][n][4]

    /// Height, its slopes and its rate at a label, as ocean/wakes/wake_layer.clh has them.
    std::array<double, 4> at(double x_m, double z_m) const;
  };
  std::vector<Instant> read() const;
  /// The windows row by row from their corners, with their foam.
  std::vector<WakeFields> read_fields() const;

 private:
  struct Place {
    double origin_x_m, origin_z_m, cell_m;
  };

  ocl::Device device_;
  std::vector<WakeLayer> layers_;
  std::vector<Place> places_;
  ocl::Buffer<float> maps_, shown_;
  ocl::Buffer<WakeLayer> layers_buffer_;
};

}  // namespace offing::ocean
