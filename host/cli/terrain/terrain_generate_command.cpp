#include <algorithm>
#include <bit>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <CLI/Option.hpp>
#include <fmt/format.h>

#include "host/base/argument.h"
#include "host/base/error.h"
#include "host/base/progress.h"
#include "host/cli/terrain/terrain_commands.h"
#include "host/cli/terrain/terrain_place.h"
#include "host/command_line/new_output.h"
#include "host/command_line/print_results.h"
#include "host/io/atomic_file.h"
#include "host/io/file_extension.h"
#include "host/io/height_maps/new_raster.h"
#include "host/terrain/generate/fractal_terrain.h"

namespace offing::cli {

namespace {

static_assert(std::endian::native == std::endian::little, ".r32 is written as it lies in memory");

struct TerrainGenerateArguments {
  std::string output, posts, side, relief, mean, longest, roughness, erosion, island, seed;
  bool json = false;
  Existing existing = Existing::keep;
};

terrain::FractalParameters read_parameters(const TerrainGenerateArguments& arguments) {
  terrain::FractalParameters parameters;
  const auto number = [](const char* flag, const std::string& text, double& value, double low, double high,
                         const char* example) {
    if (!text.empty()) value = read_number(flag, text, "", low, high, example);
  };
  if (!arguments.posts.empty()) {
    parameters.posts = static_cast<int>(read_whole("--posts", arguments.posts, 2, 65536, "1025"));
  }
  number("--side-m", arguments.side, parameters.side_m, 1.0, 1e7, "20000");
  number("--relief-m", arguments.relief, parameters.relief_m, 0.0, 2e4, "1500");
  number("--mean-m", arguments.mean, parameters.mean_m, -1e4, 1e4, "600");
  number("--longest-m", arguments.longest, parameters.longest_m, 1e-3 * parameters.side_m, 1e7, "9000");
  number("--roughness", arguments.roughness, parameters.roughness, 0.2, 0.8, "0.5");
  number("--erosion", arguments.erosion, parameters.erosion, 0.0, 1.0, "0.7");
  if (!arguments.island.empty()) {
    parameters.island_radius_m = read_number("--island-radius-m", arguments.island, "", 1.0, 1e7, "2000");
  }
  if (!arguments.seed.empty()) {
    constexpr std::int64_t most = std::int64_t{1} << 53;
    parameters.seed = static_cast<std::uint64_t>(read_whole("--seed", arguments.seed, 0, most, "7"));
  }
  return parameters;
}

/// Floats without a header (.r32), or a GeoTIFF.
class TerrainFile {
 public:
  TerrainFile(const std::string& name, int posts, double spacing_m, Existing existing) {
    if (name.ends_with(".r32")) {
      raw_.emplace(name, existing);
    } else {
      raster_.emplace(name, posts, posts, spacing_m, existing);
    }
  }
  void add_rows(std::span<const float> heights_m) {
    if (raw_) {
      raw_->write(heights_m.data(), heights_m.size_bytes());
    } else {
      raster_->add_rows(heights_m);
    }
  }
  void commit() {
    if (raw_) {
      raw_->commit();
    } else {
      raster_->commit();
    }
  }

 private:
  std::optional<AtomicFile> raw_;
  std::optional<HeightRasterWriter> raster_;
};

void run(const TerrainGenerateArguments& arguments, const GlobalOptions& options) {
  const terrain::FractalParameters parameters = read_parameters(arguments);
  require_extension(arguments.output, {".r32", ".tif", ".tiff"});
  const bool is_raw = arguments.output.ends_with(".r32");
  const double spacing_m = parameters.side_m / (parameters.posts - 1);
  require_new(arguments.output, arguments.existing);
  TerrainFile file(arguments.output, parameters.posts, spacing_m, arguments.existing);
  float lowest_m = 0.0f, highest_m = 0.0f;
  {
    Progress progress(parameters.posts, "rows", options.verbosity);
    terrain::RowMakers makers(parameters);
    for (int first = 0; first < parameters.posts; first += makers.rows_at_once()) {
      options.cancel.throw_if_cancelled();
      const std::span<const float> heights_m = makers.make(first);
      const auto [low, high] = std::minmax_element(heights_m.begin(), heights_m.end());
      lowest_m = first == 0 ? *low : std::min(lowest_m, *low);
      highest_m = first == 0 ? *high : std::max(highest_m, *high);
      file.add_rows(heights_m);
      for (std::size_t row = 0; row < heights_m.size() / static_cast<std::size_t>(parameters.posts); ++row)
        progress.advance();
    }
  }
  file.commit();
  if (arguments.json) {
    print_json({{"file", arguments.output},
                {"columns", parameters.posts},
                {"rows", parameters.posts},
                {"spacing_m", spacing_m},
                {"lowest_m", lowest_m},
                {"highest_m", highest_m}});
  } else {
    print_summary("{}: {} x {} posts, {:g} ... {:g} m{}\n", one_line(arguments.output), parameters.posts,
                  parameters.posts, lowest_m, highest_m,
                  is_raw ? fmt::format("; read it with --raw-size {}x{} --spacing-m {:.10g}",
                                       parameters.posts, parameters.posts, spacing_m)
                         : "");
  }
}

}  // namespace

void add_terrain_generate_command(CLI::App& terrain, GlobalOptions& options) {
  const auto arguments = std::make_shared<TerrainGenerateArguments>();
  CLI::App* command = terrain.add_subcommand("generate", "made ground, for scenes without data");
  const auto add = [&](const char* names, std::string& target, const char* placeholder, const char* help) {
    return command->add_option(names, target, help)->type_name(placeholder);
  };
  add("-o,--output", arguments->output, "FILE", "height map to write: .tif, or .r32, floats without a header")
      ->required();
  add("--posts", arguments->posts, "N", "posts a side, 2 ... 65536 (default 1025)");
  add("--side-m", arguments->side, "L", "length of a side, m (default 20000)");
  add("--relief-m", arguments->relief, "H", "about what lies between lowest and highest, m (default 1500)");
  add("--mean-m", arguments->mean, "H", "about the middle between them, m above the sea (default 600)");
  add("--longest-m", arguments->longest, "L", "wavelength of the largest hills, m (default 9000)");
  add("--roughness", arguments->roughness, "R", "0.2 smooth ... 0.8 jagged (default 0.5)");
  add("--erosion", arguments->erosion, "E", "gullies that water has cut, 0 none ... 1 deep (default 0)");
  add("--island-radius-m", arguments->island, "M",
      "an island: the ground sinks by the relief from its middle to this distance (default: it does not)");
  add("--seed", arguments->seed, "S", "another ground for each whole number (default 1)");
  add_force_flag(*command, arguments->existing);
  command->add_flag("--json", arguments->json, "results for scripts");
  add_global_options(*command, options, DeviceUse::none);
  command->footer(R"(
The same seed gives the same ground, whatever the number of posts. Rows are written as they are made.

Example:
  offing terrain generate --posts 2049 --seed 7 -o valley.tif
  offing terrain render valley.tif -o valley.png)");
  command->callback([arguments, &options] { run(*arguments, options); });
}

}  // namespace offing::cli
