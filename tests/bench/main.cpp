// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#include <cstdio>
#include <exception>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/log.h"
#include "host/command_line/help_format.h"
#include "tests/bench/benches.h"

namespace {

using offing::Error;
using offing::ErrorKind;
namespace bench = offing::bench;

struct Options {
  bench::Settings settings{.sizes = {64, 128, 256, 512, 1024, 2048}};
  bool wants_json = false;
};

void require_sizes(const std::vector<int>& sizes) {
  for (const int size : sizes) {
    if (size < 16 || size > 4096 || (size & (size - 1)) != 0) {
      throw Error(ErrorKind::bad_usage,
                  fmt::format("--sizes: expected powers of two from 16 to 4096, got {}", size),
                  "for example --sizes 256,512");
    }
  }
}

void add_options(CLI::App& command, Options& options) {
  command.add_flag("--json", options.wants_json, "print an array of rows instead of a table");
  command
      .add_option("--sizes", options.settings.sizes,
                  "sizes n of n x n samples, powers of two from 16 to 4096")
      ->delimiter(',')
      ->type_name("INT,...")
      ->capture_default_str();
  command
      .add_option("--blocks", options.settings.blocks, "blocks of ours and of the peer, in turn, 1 to 10000")
      ->check(CLI::Range(1, 10000).description(""))
      ->type_name("N")
      ->capture_default_str();
  command.add_option("--device", options.settings.device,
                     "index, type or part of the name, as `offing devices` lists");
}

using Benchmark =
    std::function<void(const offing::ocl::Device&, const bench::Settings&, const bench::Sinks&)>;

/// In the place of a benchmark whose peer was not found when this program was configured.
[[maybe_unused]] Benchmark without(const char* peer, const char* package) {
  return [=](const auto&, const auto&, const auto&) {
    throw Error(ErrorKind::bad_usage,
                fmt::format("expected {} as the peer, but offing-bench was built without it", peer),
                fmt::format("install {}, then run ./dev build", package));
  };
}

#ifdef OFFING_FFTW
const Benchmark fft = bench::bench_fft;
const Benchmark ocean = [](const auto& device, const auto& settings, const auto& sinks) {
  bench::bench_ocean(device, settings, sinks);
  bench::bench_start(settings, sinks);
};
const Benchmark wake = bench::bench_wake;
#else
const Benchmark fft = without("FFTW", "libfftw3-dev"), ocean = fft, wake = fft;
#endif

#ifdef OFFING_EMBREE
const Benchmark terrain = bench::bench_terrain;
#else
const Benchmark terrain = without("Embree", "libembree-dev");
#endif

/// Runs a benchmark and prints its rows: the table as they come, JSON at the end.
void run(const Options& options, const Benchmark& benchmark) {
  require_sizes(options.settings.sizes);
  const offing::ocl::Device device = offing::ocl::Device::open(options.settings.device);
  std::vector<bench::Row> rows;
  if (!options.wants_json) {
    fmt::print("{}: {}\n{}\n", device.info().platform, device.info().name, bench::table_heading());
  }
  const bench::Sinks sinks{.row =
                               [&](const bench::Row& row) {
                                 rows.push_back(row);
                                 if (options.wants_json) return;
                                 fmt::print("{}\n", bench::table_line(row));
                                 std::fflush(stdout);
                               },
                           .note = [](const std::string& note) { fmt::print(stderr, "{}\n", note); }};
  benchmark(device, options.settings, sinks);
  if (options.wants_json) fmt::print("{}\n", bench::to_json(rows));
}

int run_command_line(int argc, char** argv) {
  CLI::App app{"Offing's kernels against their peers, side by side in one process"};
  offing::format_help(app);
  app.set_help_flag("-h,--help", "print this help");
  app.require_subcommand(1);
  Options options;

  const auto add = [&](const char* name, const char* help, const Benchmark& benchmark) {
    CLI::App& command = *app.add_subcommand(name, help);
    add_options(command, options);
    command.callback([&options, benchmark] { run(options, benchmark); });
  };
  add("fft", "the inverse transform against FFTW", fft);
  add("ocean", "a frame of the sea against C++ with FFTW, and the start-up", ocean);
  add("gerstner", "the surface of 16 Gerstner waves against C++", bench::bench_gerstner);

#ifdef OFFING_BUILD_VIEWER
  add("render", "frames of the presenter and their stages",
      [](const auto&, const auto& settings, const auto& sinks) { bench::bench_render(settings, sinks); });
  add("world", "frames of a whole world beside its parts alone",
      [](const auto&, const auto& settings, const auto& sinks) { bench::bench_world(settings, sinks); });
#endif

  add("queries", "the water at 1e5 points, with two cascades and 16 Gerstner waves, against C++",
      bench::bench_queries);
  add("previews", "maps of a sea from above, as `offing ocean bake --preview` makes them",
      bench::bench_previews);
  add("terrain", "rays at height maps against Embree, on real maps if OFFING_TEST_DATA is set", terrain);
  add("viewshed", "what is seen from a point against GDAL, on real maps too if OFFING_TEST_DATA is set",
      bench::bench_viewshed);
  add("wake", "a step of a wake window against C++ with FFTW", wake);
  add("clouds", "clouds made, lit, sorted and drawn",
      [](const auto& device, const auto& settings, const auto& sinks) {
#ifdef OFFING_BUILD_VIEWER
        bench::bench_cloud_frames(settings, sinks);
#endif
        bench::bench_cloud_files(device, sinks);
        bench::bench_clouds(device, settings, sinks);
      });
#ifdef OFFING_BUILD_MESH_TOOLS
  add("curvature", "curvatures of a noisy mesh against CGAL's jets", bench::bench_curvature);
  add("highlights",
      "searches for highlights and frames of them, on the penguin too if OFFING_TEST_DATA is set",
      bench::bench_highlights);
#endif

  CLI::App& first_frame = *app.add_subcommand("first-frame", "what the start-up benchmark starts");
  first_frame.group("");
  first_frame.add_option("--device", options.settings.device);
  first_frame.callback([&] { bench::make_first_frame(options.settings.device); });

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) return app.exit(error);
    throw Error(ErrorKind::bad_usage, error.what(), "offing-bench --help lists commands and options");
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  // Parts of scenes are measured: what they leave unused is no news.
  offing::configure_log(offing::Verbosity::quiet);
  try {
    return run_command_line(argc, argv);
  } catch (const Error& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    if (!error.hint().empty()) fmt::print(stderr, "hint: {}\n", error.hint());
    return exit_code(error.kind());
  } catch (const std::exception& error) {
    fmt::print(stderr, "error: {}\nhint: choose smaller --sizes if memory is short\n", error.what());
    return 1;
  }
}
