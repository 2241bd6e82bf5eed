#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "host/base/progress.h"
#include "host/cli/common/device_choice.h"
#include "host/cli/terrain/earth_curve_flags.h"
#include "host/cli/terrain/map_raster.h"
#include "host/cli/terrain/terrain_commands.h"
#include "host/cli/terrain/terrain_input.h"
#include "host/command_line/new_output.h"
#include "host/command_line/print_results.h"
#include "host/command_line/setting_options.h"
#include "host/io/file_extension.h"
#include "host/terrain/analysis/horizons.h"
#include "host/terrain/analysis/sky_view.h"

namespace offing::cli {

namespace {

struct SkySettings {
  int azimuths = terrain::usual_azimuths;
};

struct TerrainSkyArguments {
  TerrainInput input;
  EarthCurveFlags curve;
  SettingOptions<SkySettings> settings;
  std::string output, horizons;
  bool json = false;
  Existing existing = Existing::keep;
};

/// The file of horizons: a band an azimuth, in degrees up from level.
std::unique_ptr<BandedRasterWriter> create_horizons(const TerrainSkyArguments& arguments,
                                                    const HeightMap& map, const terrain::RowBand& first,
                                                    int azimuths) {
  std::vector<BandedRaster::Band> bands;
  for (int i = 0; i < azimuths; ++i) {
    bands.push_back({"deg", fmt::format("horizon at azimuth {:g} deg", 360.0 * i / azimuths)});
  }
  return create_banded_raster(arguments.horizons, raster_on_map(map, first, false, std::move(bands)),
                              arguments.existing);
}

/// Rises as degrees, to a hundredth: horizons are not better known, and files stay small.
void to_degrees(std::span<float> rises) {
  constexpr float degrees = 180.0f / std::numbers::pi_v<float>;
  for (float& rise : rises) rise = 0.01f * std::round(100.0f * degrees * std::atan(rise));
}

void run_sky(const TerrainSkyArguments& arguments, const GlobalOptions& options) {
  for (const std::string& file : {arguments.output, arguments.horizons}) {
    if (!file.empty()) require_extension(file, {".tif", ".tiff"});
  }
  require_distinct({{"--output", arguments.output}, {"--horizons", arguments.horizons}});
  for (const std::string& file : {arguments.output, arguments.horizons}) {
    require_new(file, arguments.existing, {{arguments.input.file()}, arguments.input.trust()});
  }
  const int azimuths = arguments.settings.read().azimuths;
  const terrain::EarthCurve curve = arguments.curve.read();
  const HeightMap map = arguments.input.read().map;
  const ocl::Device device = ocl::Device::open(choose_one_device(options.device));
  const terrain::HeightField field = make_field(map, device);
  terrain::Horizons horizons(device, field, azimuths, {}, curve);
  terrain::SkyView sky(device, horizons);
  const std::vector<terrain::RowBand> bands = horizons.bands();
  const auto factors = create_banded_raster(
      arguments.output, raster_on_map(map, bands.front(), false, {{"1", "sky-view factor"}}),
      arguments.existing);
  std::unique_ptr<BandedRasterWriter> angles;
  if (!arguments.horizons.empty()) angles = create_horizons(arguments, map, bands.front(), azimuths);
  Progress progress(static_cast<int>(bands.size()), "blocks of rows", options.verbosity);
  RasterRange range;
  std::vector<float> values;
  for (const terrain::RowBand& band : bands) {
    options.cancel.throw_if_cancelled();
    values.resize(static_cast<std::size_t>(band.rows) * static_cast<std::size_t>(map.columns));
    horizons.at(band);
    sky.read(band, values);
    mark_voids<float>(map, band, float_nodata, values);
    factors->write(0, band.first_row, std::span<const float>(values));
    range.add(values);
    for (int i = 0; angles && i < azimuths; ++i) {
      horizons.read(static_cast<std::size_t>(i), values);
      to_degrees(values);
      mark_voids<float>(map, band, float_nodata, values);
      angles->write(static_cast<std::size_t>(i), band.first_row, std::span<const float>(values));
    }
    progress.advance();
  }
  options.cancel.throw_if_cancelled();
  if (angles) angles->commit();
  factors->commit();
  if (arguments.json) {
    print_json({{"file", arguments.output},
                {"columns", map.columns},
                {"rows", map.rows},
                {"azimuths", azimuths},
                {"lowest", range.low()},
                {"mean", range.mean()},
                {"highest", range.high()},
                {"void_posts", std::count(map.is_void.begin(), map.is_void.end(), 1)}});
  } else {
    print_summary("{}: sky-view factors {:.4f} ... {:.4f}, mean {:.4f}\n", one_line(arguments.output),
                  range.low(), range.high(), range.mean());
  }
}

}  // namespace

void add_terrain_sky_command(CLI::App& terrain, GlobalOptions& options) {
  const auto arguments = std::make_shared<TerrainSkyArguments>();
  CLI::App* command = terrain.add_subcommand("sky", "write the sky-view factor and horizons of each post");
  arguments->input.add_to(*command);
  arguments->settings.add_to(
      *command, {{&SkySettings::azimuths,
                  {.key = "azimuths",
                   .low = static_cast<double>(terrain::fewest_azimuths),
                   .high = static_cast<double>(terrain::most_azimuths),
                   .help = "azimuths in which horizons are found, equally spaced from the map's north"}}});
  arguments->curve.add_to(*command);
  command->add_option("-o,--output", arguments->output, "GeoTIFF of sky-view factors to write (.tif)")
      ->type_name("FILE")
      ->required();
  command
      ->add_option("--horizons", arguments->horizons,
                   "also write a GeoTIFF of horizons: a band per azimuth, in degrees up from level")
      ->type_name("FILE");
  add_force_flag(*command, arguments->existing);
  command->add_flag("--json", arguments->json, "print the results as JSON");
  add_global_options(*command, options, DeviceUse::one);
  command->footer(R"(
The sky-view factor of a post is the light that the ground there gets from an evenly bright sky, as a share
of what level ground in the open gets. Light is weighted by the cosine to the ground's normal, so an open
slope of angle b has (1 + cos b) / 2. Horizons follow the surface between the posts; they are never below
level. Azimuths are clockwise from the map's north. The rasters have the georeference of the map.

Examples:
  offing terrain sky S33W071.tif -o sky.tif
  offing terrain sky S33W071.tif --azimuths 36 --horizons horizons.tif -o sky.tif)");
  command->callback([arguments, &options] { run_sky(*arguments, options); });
}

}  // namespace offing::cli
