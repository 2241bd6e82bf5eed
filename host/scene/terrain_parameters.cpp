#include "host/scene/terrain_parameters.h"

#include "host/scene/parameter_storage.h"

namespace offing::scene {

namespace {

constexpr auto ground = &OceanScene::terrain;
constexpr auto reading = &TerrainScene::reading;

/// Samples of files without a header: by the file's name, or as it says here.
ChoiceStorage raw_types() {
  using Type = std::optional<RawType>;
  return {.names = {"by_name", "u16", "s16", "f32"},
          .get =
              [](OceanScene& scene, ElementIndex) {
                const Type type = scene.terrain.reading.raw_type;
                return type ? static_cast<std::size_t>(*type) + 1 : 0;
              },
          .set =
              [](OceanScene& scene, ElementIndex, std::size_t index) {
                scene.terrain.reading.raw_type = index == 0 ? Type{} : static_cast<RawType>(index - 1);
              }};
}

ChoiceStorage reprojections() {
  return {.names = {"none", "utm"},
          .get = [](OceanScene& scene, ElementIndex) -> std::size_t {
            return scene.terrain.reading.reproject_to == "utm";
          },
          .set = [](OceanScene& scene, ElementIndex,
                    std::size_t index) { scene.terrain.reading.reproject_to = index == 0 ? "" : "utm"; }};
}

std::vector<Parameter> file_rows() {
  constexpr auto group = ParameterGroup::height_map;
  constexpr auto use = ParameterUse::terrain_file;
  return {
      {.key = "terrain.file",
       .flag = "",
       .group = group,
       .storage = &member<ground, &TerrainScene::file>,
       .help = "height map: GeoTIFF, .hgt, USGS DEM, ASCII grid, PNG, EXR, .r16, .r32; or a tile store",
       .example = "andes.tif",
       .absent = "none: made ground",
       .rule = ParameterRule::file_name},
      {.key = "terrain.vertical_scale",
       .flag = "",
       .group = group,
       .storage = &member<ground, reading, &HeightMapOptions::vertical_scale>,
       .low = -1e4,
       .high = 1e4,
       .help = "metres a unit of the file's heights, after the file's own scale and unit",
       .use = use},
      {.key = "terrain.offset_m",
       .flag = "",
       .group = group,
       .storage = &member<ground, reading, &HeightMapOptions::offset_m>,
       .unit = "m",
       .low = -2e4,
       .high = 2e4,
       .help = "added to the heights; 0 m is the level of the sea",
       .use = use},
      {.key = "terrain.spacing_x_m",
       .flag = "",
       .group = group,
       .storage = &member<ground, reading, &HeightMapOptions::spacing_x_m>,
       .unit = "m",
       .low = 0.001,
       .high = 1e5,
       .help = "distance of the file's posts from west to east",
       .example = "30",
       .absent = "as the file says",
       .use = use},
      {.key = "terrain.spacing_z_m",
       .flag = "",
       .group = group,
       .storage = &member<ground, reading, &HeightMapOptions::spacing_z_m>,
       .unit = "m",
       .low = 0.001,
       .high = 1e5,
       .help = "distance of the file's posts from north to south",
       .example = "30",
       .absent = "as the file says",
       .use = use},
      {.key = "terrain.reproject",
       .flag = "",
       .group = group,
       .storage = reprojections(),
       .help = "resample a map in degrees to metres: utm, in the zone of its middle",
       .use = use},
      {.key = "terrain.horizontal_unit",
       .flag = "",
       .group = group,
       .storage = choice<ground, reading, &HeightMapOptions::horizontal_unit>({"of_file", "metre", "degree"}),
       .help = "what coordinates count in, where the file does not say",
       .use = use},
      {.key = "terrain.encoding",
       .flag = "",
       .group = group,
       .storage = choice<ground, reading, &HeightMapOptions::encoding>({"plain", "mapbox", "terrarium"}),
       .help = "how heights lie in samples: mapbox and terrarium pack them into 8-bit RGB",
       .use = use},
      {.key = "terrain.band",
       .flag = "",
       .group = group,
       .storage = &member<ground, reading, &HeightMapOptions::band>,
       .low = 1.0,
       .high = 65535.0,
       .help = "band of the file that holds heights, counted from 1",
       .use = use},
      {.key = "terrain.nodata",
       .flag = "",
       .group = group,
       .storage = &member<ground, reading, &HeightMapOptions::nodata>,
       .low = -1e38,
       .high = 1e38,
       .help = "value of the file's that marks voids too, before any scale",
       .example = "-9999",
       .absent = "those that the file marks",
       .use = use},
      {.key = "terrain.void_height_m",
       .flag = "",
       .group = group,
       .storage = &member<ground, reading, &HeightMapOptions::void_height_m>,
       .unit = "m",
       .low = -12e3,
       .high = 20e3,
       .help = "height of voids",
       .example = "0",
       .absent = "filled from the posts around them",
       .use = use},
      {.key = "terrain.raw_columns",
       .flag = "",
       .group = group,
       .storage = &member<ground, reading, &HeightMapOptions::raw_columns>,
       .high = 1e6,
       .help = "posts along x of a file without a header (.r16, .r32, .raw, .bin)",
       .use = use},
      {.key = "terrain.raw_rows",
       .flag = "",
       .group = group,
       .storage = &member<ground, reading, &HeightMapOptions::raw_rows>,
       .high = 1e6,
       .help = "posts along z of a file without a header",
       .use = use},
      {.key = "terrain.raw_type",
       .flag = "",
       .group = group,
       .storage = raw_types(),
       .help = "samples of a file without a header; by_name: .r16 u16, .r32 f32",
       .use = use},
      {.key = "terrain.raw_order",
       .flag = "",
       .group = group,
       .storage = choice<ground, reading, &HeightMapOptions::raw_byte_order>({"little", "big"}),
       .help = "byte order of a file without a header",
       .use = use},
      {.key = "terrain.cache_mb",
       .flag = "",
       .group = group,
       .storage = &member<ground, &TerrainScene::cache_mb>,
       .unit = "MiB",
       .low = 32.0,
       .high = 65536.0,
       .help = "memory for the tiles of a tile store",
       .use = ParameterUse::tile_store},
  };
}

std::vector<Parameter> made_rows() {
  using terrain::FractalParameters;
  constexpr auto group = ParameterGroup::terrain;
  constexpr auto use = ParameterUse::made_ground;
  constexpr auto fractal = &TerrainScene::fractal;
  return {
      {.key = "terrain.seed",
       .flag = "",
       .group = group,
       .storage = &member<ground, fractal, &FractalParameters::seed>,
       .high = 9223372036854775807.0,
       .help = "number that picks one made ground among all of the same shape",
       .use = use},
      {.key = "terrain.posts",
       .flag = "",
       .group = group,
       .storage = &member<ground, fractal, &FractalParameters::posts>,
       .low = 2.0,
       .high = 16384.0,
       .help = "posts along a side of made ground",
       .use = use},
      {.key = "terrain.side_m",
       .flag = "",
       .group = group,
       .storage = &member<ground, fractal, &FractalParameters::side_m>,
       .unit = "m",
       .low = 1.0,
       .high = 1e6,
       .help = "length of a side of made ground",
       .use = use},
      {.key = "terrain.relief_m",
       .flag = "",
       .group = group,
       .storage = &member<ground, fractal, &FractalParameters::relief_m>,
       .unit = "m",
       .low = 0.0,
       .high = 2e4,
       .help = "about what lies between the lowest and the highest of made ground",
       .use = use},
      {.key = "terrain.mean_m",
       .flag = "",
       .group = group,
       .storage = &member<ground, fractal, &FractalParameters::mean_m>,
       .unit = "m",
       .low = -1e4,
       .high = 1e4,
       .help = "about the middle between them; 0 m is the level of the sea",
       .use = use},
      {.key = "terrain.longest_m",
       .flag = "",
       .group = group,
       .storage = &member<ground, fractal, &FractalParameters::longest_m>,
       .unit = "m",
       .low = 1.0,
       .high = 1e7,
       .help = "wavelength of the largest hills of made ground, from a thousandth of the side on",
       .use = use},
      {.key = "terrain.roughness",
       .flag = "",
       .group = group,
       .storage = &member<ground, fractal, &FractalParameters::roughness>,
       .low = 0.2,
       .high = 0.8,
       .help = "height of each octave of made ground over that of the one before: 0.2 smooth ... 0.8 jagged",
       .use = use},
      {.key = "terrain.erosion",
       .flag = "",
       .group = group,
       .storage = &member<ground, fractal, &FractalParameters::erosion>,
       .low = 0.0,
       .high = 1.0,
       .help = "how deep gullies are cut into slopes: 0 none",
       .use = use},
  };
}

std::vector<Parameter> place_rows() {
  constexpr auto group = ParameterGroup::terrain;
  return {
      {.key = "terrain.origin_x_m",
       .flag = "",
       .group = group,
       .storage = &member<ground, &TerrainScene::origin_x_m>,
       .unit = "m",
       .low = -1e6,
       .high = 1e6,
       .help = "the western posts, east of the origin",
       .example = "0",
       .absent = "the map's middle is at the origin"},
      {.key = "terrain.origin_z_m",
       .flag = "",
       .group = group,
       .storage = &member<ground, &TerrainScene::origin_z_m>,
       .unit = "m",
       .low = -1e6,
       .high = 1e6,
       .help = "the northern posts, south of the origin",
       .example = "0",
       .absent = "the map's middle is at the origin"},
      {.key = "terrain.water_line_m",
       .flag = "",
       .group = group,
       .storage = &member<ground, &TerrainScene::water_line_m>,
       .unit = "m",
       .low = -2e4,
       .high = 2e4,
       .help = "ground at or below is painted as water, where the scene has no sea",
       .use = ParameterUse::dry_scene},
      {.key = "terrain.tree_line_m",
       .flag = "",
       .group = group,
       .storage = &member<ground, &TerrainScene::tree_line_m>,
       .unit = "m",
       .low = -2e4,
       .high = 2e4,
       .help = "where woods end",
       .example = "1800",
       .absent = "by the latitude that the file tells, else 2000"},
      {.key = "terrain.snow_line_m",
       .flag = "",
       .group = group,
       .storage = &member<ground, &TerrainScene::snow_line_m>,
       .unit = "m",
       .low = -2e4,
       .high = 2e4,
       .help = "where snow begins",
       .example = "2600",
       .absent = "by the latitude that the file tells, else 2800"},
      {.key = "terrain.colour",
       .flag = "",
       .group = group,
       .storage = &member<ground, &TerrainScene::colour>,
       .help = "picture of the ground from above (GeoTIFF, PNG ...), placed by its georeference or else "
               "stretched over the map",
       .example = "orthophoto.tif",
       .absent = "none: colours by height and slope",
       .rule = ParameterRule::file_name},
      {.key = "terrain.sky_visibility",
       .flag = "",
       .group = group,
       .storage = choice<ground, &TerrainScene::sky_visibility>({"off", "on"}),
       .help =
           "whether ground around a place hides the sky's light from it; costs a second or two at the start",
       .use = ParameterUse::whole_map},
  };
}

}  // namespace

std::vector<Parameter> terrain_parameters() {
  std::vector<Parameter> rows;
  for (const std::vector<Parameter>& more : {made_rows(), file_rows(), place_rows()}) {
    rows.insert(rows.end(), more.begin(), more.end());
  }
  return rows;
}

}  // namespace offing::scene
