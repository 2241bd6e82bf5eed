#include <algorithm>
#include <bit>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <CLI/Option.hpp>
#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/progress.h"
#include "host/cli/terrain/terrain_commands.h"
#include "host/cli/terrain/terrain_place.h"
#include "host/command_line/new_output.h"
#include "host/command_line/print_results.h"
#include "host/command_line/setting_options.h"
#include "host/io/atomic_file.h"
#include "host/io/file_extension.h"
#include "host/io/height_maps/new_raster.h"
#include "host/terrain/generate/fractal_terrain.h"

namespace offing::cli {

namespace {

static_assert(std::endian::native == std::endian::little, ".r32 is written as it lies in memory");

using terrain::FractalParameters;

struct TerrainGenerateArguments {
  std::string output;
  SettingOptions<FractalParameters> terrain;
  bool json = false;
  Existing existing = Existing::keep;
};

std::vector<scene::Row<FractalParameters>> terrain_rows() {
  return {{&FractalParameters::posts, like_scene("terrain.posts", "--posts")},
          {&FractalParameters::side_m, like_scene("terrain.side_m", "--side-m")},
          {&FractalParameters::relief_m, like_scene("terrain.relief_m", "--relief-m")},
          {&FractalParameters::mean_m, like_scene("terrain.mean_m", "--mean-m")},
          {&FractalParameters::longest_m, like_scene("terrain.longest_m", "--longest-m")},
          {&FractalParameters::roughness, like_scene("terrain.roughness", "--roughness")},
          {&FractalParameters::erosion, like_scene("terrain.erosion", "--erosion")},
          {&FractalParameters::island_radius_m, like_scene("terrain.island_radius_m", "--island-radius-m")},
          {&FractalParameters::seed, like_scene("terrain.seed", "--seed")}};
}

/// Floats without a header (.r32), or a GeoTIFF.
class TerrainFile {
 public:
  TerrainFile(const std::string& name, int posts, double spacing_m, Existing existing) {
    if (name.ends_with(".r32")) {
      raw_.emplace(name, existing);
    } else {
      raster_ = create_height_raster(name, posts, posts, spacing_m, existing);
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
  std::unique_ptr<HeightRasterWriter> raster_;
};

void run(const TerrainGenerateArguments& arguments, const GlobalOptions& options) {
  const NarrowedRange waves{.flag = "--longest-m", .low = 1e-3 * arguments.terrain.read().side_m};
  const FractalParameters parameters = arguments.terrain.read({}, waves);
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
  CLI::App* command = terrain.add_subcommand("generate", "generate terrain, for scenes without data");
  command
      ->add_option("-o,--output", arguments->output,
                   "height map to write: .tif, or .r32 (32-bit floats without a header)")
      ->type_name("FILE")
      ->required();
  arguments->terrain.add_to(*command, terrain_rows());
  add_force_flag(*command, arguments->existing);
  command->add_flag("--json", arguments->json, "print the results as JSON");
  add_global_options(*command, options, DeviceUse::none);
  command->footer(R"(
The same seed gives the same terrain for any number of posts. Each row is written as soon as it is made.

Examples:
  offing terrain generate --posts 2049 --seed 7 -o valley.tif
  offing terrain render valley.tif -o valley.png)");
  command->callback([arguments, &options] { run(*arguments, options); });
}

}  // namespace offing::cli
