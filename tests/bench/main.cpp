// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#include <cstdio>
#include <exception>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/log.h"
#include "host/command_line/parse_arguments.h"
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

/// Runs a benchmark and prints its rows: the table as they come, JSON at the end.
void run(const Options& options,
         const std::function<void(const offing::ocl::Device&, const bench::Sinks&)>& benchmark) {
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
  benchmark(device, sinks);
  if (options.wants_json) fmt::print("{}\n", bench::to_json(rows));
}

int run_command_line(int argc, char** argv) {
  CLI::App app{"Offing's kernels against their peers, side by side in one process"};
  offing::format_help(app);
  app.set_help_flag("-h,--help", "print this help");
  app.require_subcommand(1);
  Options options;

  CLI::App& fft = *app.add_subcommand("fft", "the inverse transform against FFTW");
  add_options(fft, options);
  fft.callback([&] {
    run(options, [&](const auto& device, const bench::Sinks& sinks) {
      bench::bench_fft(device, options.settings, sinks);
    });
  });

  CLI::App& ocean =
      *app.add_subcommand("ocean", "a frame of the sea against C++ with FFTW, and the start-up");
  add_options(ocean, options);
  ocean.callback([&] {
    run(options, [&](const auto& device, const bench::Sinks& sinks) {
      bench::bench_ocean(device, options.settings, sinks);
      bench::bench_start(options.settings, sinks);
    });
  });

  CLI::App& gerstner = *app.add_subcommand("gerstner", "the surface of 16 Gerstner waves against C++");
  add_options(gerstner, options);
  gerstner.callback([&] {
    run(options, [&](const auto& device, const bench::Sinks& sinks) {
      bench::bench_gerstner(device, options.settings, sinks);
    });
  });

#ifdef OFFING_BUILD_VIEWER
  CLI::App& render = *app.add_subcommand("render", "frames of the presenter and their stages");
  add_options(render, options);
  render.callback([&] {
    run(options,
        [&](const auto&, const bench::Sinks& sinks) { bench::bench_render(options.settings, sinks); });
  });

  CLI::App& world = *app.add_subcommand("world", "frames of a whole world beside its parts alone");
  add_options(world, options);
  world.callback([&] {
    run(options,
        [&](const auto&, const bench::Sinks& sinks) { bench::bench_world(options.settings, sinks); });
  });
#endif

  CLI::App& queries = *app.add_subcommand(
      "queries", "the water at 1e5 points, with two cascades and 16 Gerstner waves, against C++");
  add_options(queries, options);
  queries.callback([&] {
    run(options, [&](const auto& device, const bench::Sinks& sinks) {
      bench::bench_queries(device, options.settings, sinks);
    });
  });

  CLI::App& terrain = *app.add_subcommand(
      "terrain", "rays at height maps against Embree 3, on real maps if OFFING_TEST_DATA is set");
  add_options(terrain, options);
  terrain.callback([&] {
    run(options, [&](const auto& device, const bench::Sinks& sinks) {
      bench::bench_terrain(device, options.settings, sinks);
    });
  });

  CLI::App& viewshed = *app.add_subcommand(
      "viewshed", "what is seen from a point against GDAL, on real maps too if OFFING_TEST_DATA is set");
  add_options(viewshed, options);
  viewshed.callback([&] {
    run(options, [&](const auto& device, const bench::Sinks& sinks) {
      bench::bench_viewshed(device, options.settings, sinks);
    });
  });

  CLI::App& wake = *app.add_subcommand("wake", "a step of a wake window against C++ with FFTW");
  add_options(wake, options);
  wake.callback([&] {
    run(options, [&](const auto& device, const bench::Sinks& sinks) {
      bench::bench_wake(device, options.settings, sinks);
    });
  });

  CLI::App& clouds = *app.add_subcommand("clouds", "clouds made, lit, sorted and drawn");
  add_options(clouds, options);
  clouds.callback([&] {
    run(options, [&](const auto& device, const bench::Sinks& sinks) {
#ifdef OFFING_BUILD_VIEWER
      bench::bench_cloud_frames(options.settings, sinks);
#endif
      bench::bench_cloud_files(device, sinks);
      bench::bench_clouds(device, options.settings, sinks);
    });
  });
#ifdef OFFING_BUILD_MESH_TOOLS
  CLI::App& curvature = *app.add_subcommand("curvature", "curvatures of a noisy mesh against CGAL's jets");
  add_options(curvature, options);
  curvature.callback([&] {
    run(options, [&](const auto& device, const bench::Sinks& sinks) {
      bench::bench_curvature(device, options.settings, sinks);
    });
  });
  CLI::App& highlights = *app.add_subcommand(
      "highlights",
      "searches for highlights and frames of them, on the penguin too if OFFING_TEST_DATA is set");
  add_options(highlights, options);
  highlights.callback([&] {
    run(options, [&](const auto& device, const bench::Sinks& sinks) {
      bench::bench_highlights(device, options.settings, sinks);
    });
  });
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
