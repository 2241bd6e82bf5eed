// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "host/ocl/device.h"
#include "tests/bench/row.h"

namespace offing::bench {

struct Settings {
  std::vector<int> sizes;  ///< n, powers of two, 16 ... 4096
  int blocks = 15;
  std::string device{};  ///< selector of ocl::select_device()
};

/// Takes each row as it is measured.
using RowSink = std::function<void(const Row&)>;
/// Takes a line on what is being done.
using NoteSink = std::function<void(const std::string&)>;

struct Sinks {
  RowSink row;
  NoteSink note;
};

/// The bare inverse transform against FFTW's fastest: one transform from 256 on, 16 at once below (four
/// fields of four cascades). Throws Error(device) where results differ.
void bench_fft(const ocl::Device& device, const Settings& settings, const Sinks& sinks);

/// One frame of the sea against the same frame in C++: a cascade of each size, and three cascades of 256.
/// Throws Error(device) where results differ.
void bench_ocean(const ocl::Device& device, const Settings& settings, const Sinks& sinks);

/// The surface of 16 Gerstner waves on a grid of each size from 64 on, against the same in C++: a loop with
/// the compiler's vector mathematics, and the best by hand. Throws Error(device) where results differ,
/// Error(bad_usage) for a smaller size.
void bench_gerstner(const ocl::Device& device, const Settings& settings, const Sinks& sinks);

/// Frames of the presenter on a framebuffer, and their stages: the shipped rough sea as its window draws it,
/// and for each size the paper's frame (O15 of docs/sources.md): one patch, 16 Gerstner waves, 1280 x 1024
/// pixels. Only in builds with the presenter.
void bench_render(const Settings& settings, const Sinks& sinks);

/// Frames of the shipped world of 640 x 360 pixels, its stages, and what its parts take alone: the sea with
/// its ship, the island, the clouds. Sizes of the settings do not matter. Only in builds with the presenter.
void bench_world(const Settings& settings, const Sinks& sinks);

/// A call for the water at 1e5 points from and to host memory, with 16 Gerstner waves and two cascades of
/// each size whose maps are made before, against a loop in C++ on all cores. Throws Error(device) where
/// results differ.
void bench_queries(const ocl::Device& device, const Settings& settings, const Sinks& sinks);

/// A preview of a frame of the shipped storm, as `offing ocean bake --preview` makes it, with cascades of
/// each size, and a contact sheet of 24 frames.
void bench_previews(const ocl::Device& device, const Settings& settings, const Sinks& sinks);

/// Primary rays of cameras that fly and walk over height maps, 1280 x 720, against the best of all ways to
/// cast them with Embree: valleys of each size, and the real maps of OFFING_TEST_DATA where that is set.
/// Throws Error(device) where hits differ.
void bench_terrain(const ocl::Device& device, const Settings& settings, const Sinks& sinks);

/// Which posts of height maps are seen from a point, all of them, against GDAL's approximate sweep: valleys
/// of each size, and the real maps of OFFING_TEST_DATA where that is set. Throws Error(device) where answers
/// differ.
void bench_viewshed(const ocl::Device& device, const Settings& settings, const Sinks& sinks);

/// Curvatures of a noisy torus of size x size / 2 vertices, from its neighbours on, by the methods of
/// offing-mesh on one core and on all, and on the device, against CGAL's jets on one core. Only in builds
/// with the mesh tools. Throws Error(device) where a method does not find the torus.
void bench_curvature(const ocl::Device& device, const Settings& settings, const Sinks& sinks);

/// Searches for highlights, against a loop over the faces on one core, and whole frames of highlights that
/// turn: points, tracks, projectors and regions, without drawing. Meshes of ours, and the penguin of
/// OFFING_TEST_DATA where that is set; the sizes of the settings do not matter. Only in builds with
/// offing-mesh. Throws Error(device) where the numbers of points differ.
void bench_highlights(const ocl::Device& device, const Settings& settings, const Sinks& sinks);

/// Cumuli made by sampling and by growth; of clouds of as many particles the light when sun or cloud changes,
/// by both models, light toward an eye that moves, the order in which it blends and the picture of 640 x 360
/// pixels: for the numbers of particles of C16 of docs/sources.md and up to a million; sizes of the settings
/// do not matter.
void bench_clouds(const ocl::Device& device, const Settings& settings, const Sinks& sinks);

/// 3,000 balls in 512^3 cells, from parameters to an OpenVDB file in the folder of temporary files.
void bench_cloud_files(const ocl::Device& device, const Sinks& sinks);

/// Frames of the presenter with a cumulus from near: the shipped one over its sea, and one alone in the sky
/// for each number of particles up to 30,000, in the window's size and in that of C16. Only in builds with
/// the presenter.
void bench_cloud_frames(const Settings& settings, const Sinks& sinks);

/// One step of a wake window of each size by either method, a hull in it, against the dispersive step in C++
/// with FFTW.
void bench_wake(const ocl::Device& device, const Settings& settings, const Sinks& sinks);

/// From the start of a process to its first 256 x 256 frame of three cascades, with an empty kernel cache and
/// with a filled one; nothing unless 256 is among the sizes.
void bench_start(const Settings& settings, const Sinks& sinks);

/// What the processes of bench_start() do: make the frame, print a line, end.
void make_first_frame(const std::string& selector);

}  // namespace offing::bench
