#include "host/io/tile_store/tile_store.h"
#include "host/scene/schema/sections.h"

namespace offing::scene {

namespace {

constexpr auto reading = &TerrainScene::reading;

/// A coordinate system's name, of which "" is none.
Where<TerrainScene> reprojections() {
  return Where<TerrainScene>(ChoiceStorage{
      .names = {"none", "utm"},
      .offset = path(reading, &HeightMapOptions::reproject_to).offset,
      .get = [](const void* value) -> std::size_t {
        return static_cast<const std::string*>(value)->empty() ? 0 : 1;
      },
      .set = [](void* value,
                std::size_t index) { *static_cast<std::string*>(value) = index == 0 ? "" : "utm"; }});
}

std::string needs_whole_map(const UseContext&, const TerrainScene& terrain) {
  return is_tile_store(terrain.file) ? "the ground is that of a tile store" : "";
}

std::string needs_map_file(const UseContext& context, const TerrainScene& terrain) {
  return terrain.file.empty() ? "terrain.file is not given, the ground is made"
                              : needs_whole_map(context, terrain);
}

std::string needs_tile_store(const UseContext&, const TerrainScene& terrain) {
  return is_tile_store(terrain.file) ? "" : "terrain.file is no tile store";
}

std::string needs_made_ground(const UseContext&, const TerrainScene& terrain) {
  return terrain.file.empty() ? "" : "the ground is that of " + terrain.file;
}

std::string needs_no_sea(const UseContext& context, const TerrainScene&) {
  return context.sea.is_there ? "the scene has a sea" : "";
}

std::vector<Row<TerrainScene>> file_rows() {
  return {
      {&TerrainScene::file,
       {.key = "file",
        .help = "height map: GeoTIFF, .hgt, USGS DEM, ASCII grid, PNG, EXR, .r16, .r32; or a tile store",
        .example = "andes.tif",
        .absent = "none: made ground",
        .rule = ParameterRule::file_name}},
      {path(reading, &HeightMapOptions::vertical_scale),
       {.key = "vertical_scale",
        .low = -1e6,
        .high = 1e6,
        .help = "metres a unit of the file's heights, after the file's own scale and unit"},
       needs_map_file},
      {path(reading, &HeightMapOptions::offset_m),
       {.key = "offset_m",
        .unit = "m",
        .low = -1e9,
        .high = 1e9,
        .help = "added to the heights; 0 m is sea level"},
       needs_map_file},
      {path(reading, &HeightMapOptions::spacing_x_m),
       {.key = "spacing_x_m",
        .unit = "m",
        .low = 0.001,
        .high = 1e5,
        .help = "distance of the file's posts from west to east",
        .example = "30",
        .absent = "as the file says"},
       needs_map_file},
      {path(reading, &HeightMapOptions::spacing_z_m),
       {.key = "spacing_z_m",
        .unit = "m",
        .low = 0.001,
        .high = 1e5,
        .help = "distance of the file's posts from north to south",
        .example = "30",
        .absent = "as the file says"},
       needs_map_file},
      {reprojections(),
       {.key = "reproject", .help = "resample a map in degrees to metres: utm, in the zone of its middle"},
       needs_map_file},
      {choice(path(reading, &HeightMapOptions::horizontal_unit), {"of_file", "metre", "degree"}),
       {.key = "horizontal_unit", .help = "what coordinates count in, where the file does not say"},
       needs_map_file},
      {choice(path(reading, &HeightMapOptions::encoding), {"plain", "mapbox", "terrarium"}),
       {.key = "encoding",
        .help = "how heights lie in samples: mapbox and terrarium pack them into 8-bit RGB"},
       needs_map_file},
      {path(reading, &HeightMapOptions::band),
       {.key = "band",
        .low = 1.0,
        .high = 65535.0,
        .help = "band of the file that holds heights, counted from 1"},
       needs_map_file},
      {path(reading, &HeightMapOptions::nodata),
       {.key = "nodata",
        .low = -1e38,
        .high = 1e38,
        .help = "another value that marks voids in the file, before any scale",
        .example = "-9999",
        .absent = "those that the file marks"},
       needs_map_file},
      {path(reading, &HeightMapOptions::void_height_m),
       {.key = "void_height_m",
        .unit = "m",
        .low = -1e6,
        .high = 1e6,
        .help = "height of voids",
        .example = "0",
        .absent = "filled from the posts around them"},
       needs_map_file},
      {path(reading, &HeightMapOptions::raw_columns),
       {.key = "raw_columns",
        .high = 1e6,
        .help = "posts along x of a file without a header (.r16, .r32, .raw, .bin)"},
       needs_map_file},
      {path(reading, &HeightMapOptions::raw_rows),
       {.key = "raw_rows", .high = 1e6, .help = "posts along z of a file without a header"},
       needs_map_file},
      {choice_or("by_name", path(reading, &HeightMapOptions::raw_type), {"u16", "s16", "f32"}),
       {.key = "raw_type", .help = "samples of a file without a header; by_name: .r16 u16, .r32 f32"},
       needs_map_file},
      {choice(path(reading, &HeightMapOptions::raw_byte_order), {"little", "big"}),
       {.key = "raw_order", .help = "byte order of a file without a header"},
       needs_map_file},
      {&TerrainScene::cache_mb,
       {.key = "cache_mb",
        .unit = "MiB",
        .low = 32.0,
        .high = 65536.0,
        .help = "memory for the tiles of a tile store"},
       needs_tile_store},
  };
}

std::vector<Row<TerrainScene>> made_rows() {
  using terrain::FractalParameters;
  constexpr auto fractal = &TerrainScene::fractal;
  return {
      {path(fractal, &FractalParameters::seed),
       {.key = "seed",
        .high = 9223372036854775807.0,
        .help = "number that picks one made ground among all of the same shape"},
       needs_made_ground},
      {path(fractal, &FractalParameters::posts),
       {.key = "posts", .low = 2.0, .high = 65536.0, .help = "posts along a side of made ground"},
       needs_made_ground},
      {path(fractal, &FractalParameters::side_m),
       {.key = "side_m", .unit = "m", .low = 1.0, .high = 1e7, .help = "length of a side of made ground"},
       needs_made_ground},
      {path(fractal, &FractalParameters::relief_m),
       {.key = "relief_m",
        .unit = "m",
        .low = 0.0,
        .high = 2e4,
        .help = "about what lies between the lowest and the highest of made ground"},
       needs_made_ground},
      {path(fractal, &FractalParameters::mean_m),
       {.key = "mean_m",
        .unit = "m",
        .low = -1e4,
        .high = 1e4,
        .help = "about the middle between them; 0 m is sea level"},
       needs_made_ground},
      {path(fractal, &FractalParameters::longest_m),
       {.key = "longest_m",
        .unit = "m",
        .low = 1.0,
        .high = 1e7,
        .help = "wavelength of the largest hills of made ground, from a thousandth of the side on"},
       needs_made_ground},
      {path(fractal, &FractalParameters::roughness),
       {.key = "roughness",
        .low = 0.2,
        .high = 0.8,
        .help =
            "height of each octave of made ground over that of the one before: 0.2 smooth ... 0.8 jagged"},
       needs_made_ground},
      {path(fractal, &FractalParameters::erosion),
       {.key = "erosion", .low = 0.0, .high = 1.0, .help = "how deep gullies are cut into slopes: 0 none"},
       needs_made_ground},
      {path(fractal, &FractalParameters::island_radius_m),
       {.key = "island_radius_m",
        .unit = "m",
        .low = 1.0,
        .high = 1e7,
        .help = "made ground sinks by relief_m from its middle to this distance: an island",
        .example = "2000",
        .absent = "it does not"},
       needs_made_ground},
  };
}

std::vector<Row<TerrainScene>> place_rows() {
  return {
      {&TerrainScene::origin_x_m,
       {.key = "origin_x_m",
        .unit = "m",
        .low = -1e6,
        .high = 1e6,
        .help = "the western posts, east of the origin",
        .example = "0",
        .absent = "the map's middle is at the origin"}},
      {&TerrainScene::origin_z_m,
       {.key = "origin_z_m",
        .unit = "m",
        .low = -1e6,
        .high = 1e6,
        .help = "the northern posts, south of the origin",
        .example = "0",
        .absent = "the map's middle is at the origin"}},
      {&TerrainScene::water_line_m,
       {.key = "water_line_m",
        .unit = "m",
        .low = -2e4,
        .high = 2e4,
        .help = "ground at or below is painted as water, where the scene has no sea"},
       needs_no_sea},
      {&TerrainScene::tree_line_m,
       {.key = "tree_line_m",
        .unit = "m",
        .low = -2e4,
        .high = 2e4,
        .help = "where woods end",
        .example = "1800",
        .absent = "by the latitude that the file tells, else 2000"}},
      {&TerrainScene::snow_line_m,
       {.key = "snow_line_m",
        .unit = "m",
        .low = -2e4,
        .high = 2e4,
        .help = "where snow begins",
        .example = "2600",
        .absent = "by the latitude that the file tells, else 2800"}},
      {&TerrainScene::colour,
       {.key = "colour",
        .help = "picture of the ground from above (GeoTIFF, PNG ...), placed by its georeference or else "
                "stretched over the map",
        .example = "orthophoto.tif",
        .absent = "none: colours by height and slope",
        .rule = ParameterRule::file_name}},
      {choice(&TerrainScene::sky_visibility, {"off", "on"}),
       {.key = "sky_visibility",
        .help = "whether ground around a place hides the sky's light from it; costs a second or two at the "
                "start"},
       needs_whole_map},
  };
}

}  // namespace

Schema<TerrainScene> terrain_schema() {
  Schema<TerrainScene> schema("terrain");
  return schema.rows(ParameterGroup::terrain, Affects::heights, made_rows())
      .rows(ParameterGroup::height_map, Affects::heights, file_rows())
      .rows(ParameterGroup::terrain, Affects::cover, place_rows());
}

}  // namespace offing::scene
