#include "host/io/tile_store/tile_store.h"
#include "host/scene/schema/sections.h"

namespace offing::scene {

namespace {

constexpr auto reading = &TerrainScene::reading;
constexpr std::size_t max_materials = 32;  // each costs every pixel of the ground

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
  return is_tile_store(terrain.file) ? "the terrain comes from a tile store" : "";
}

std::string needs_map_file(const UseContext& context, const TerrainScene& terrain) {
  return terrain.file.empty() ? "terrain.file is not given, so the terrain is generated"
                              : needs_whole_map(context, terrain);
}

std::string needs_tile_store(const UseContext&, const TerrainScene& terrain) {
  return is_tile_store(terrain.file) ? "" : "terrain.file is not a tile store";
}

std::string needs_generated_terrain(const UseContext&, const TerrainScene& terrain) {
  return terrain.file.empty() ? "" : "the terrain comes from " + terrain.file;
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
        .absent = "none: generated terrain",
        .rule = ParameterRule::file_name}},
      {path(reading, &HeightMapOptions::vertical_scale),
       {.key = "vertical_scale",
        .low = -1e6,
        .high = 1e6,
        .help = "metres per unit of the file's heights, applied after the file's own scale and unit"},
       needs_map_file},
      {path(reading, &HeightMapOptions::offset_m),
       {.key = "offset_m", .unit = "m", .low = -1e9, .high = 1e9, .help = "offset to add to the heights"},
       needs_map_file},
      {path(reading, &HeightMapOptions::spacing_x_m),
       {.key = "spacing_x_m",
        .unit = "m",
        .low = 0.001,
        .high = 1e5,
        .help = "distance between the file's posts from west to east",
        .example = "30",
        .absent = "from the file"},
       needs_map_file},
      {path(reading, &HeightMapOptions::spacing_z_m),
       {.key = "spacing_z_m",
        .unit = "m",
        .low = 0.001,
        .high = 1e5,
        .help = "distance between the file's posts from north to south",
        .example = "30",
        .absent = "from the file"},
       needs_map_file},
      {reprojections(),
       {.key = "reproject",
        .help = "resample a map in degrees to metres; utm: in the UTM zone of its middle"},
       needs_map_file},
      {choice(path(reading, &HeightMapOptions::horizontal_unit), {"of_file", "metre", "degree"}),
       {.key = "horizontal_unit", .help = "unit of the coordinates, if the file does not give it"},
       needs_map_file},
      {choice(path(reading, &HeightMapOptions::encoding), {"plain", "mapbox", "terrarium"}),
       {.key = "encoding", .help = "how samples hold heights: mapbox and terrarium pack them into 8-bit RGB"},
       needs_map_file},
      {path(reading, &HeightMapOptions::band),
       {.key = "band",
        .low = 1.0,
        .high = 65535.0,
        .help = "band of the file that holds the heights, counted from 1"},
       needs_map_file},
      {path(reading, &HeightMapOptions::nodata),
       {.key = "nodata",
        .low = -1e38,
        .high = 1e38,
        .help = "additional value that marks voids in the file, before any scaling",
        .example = "-9999",
        .absent = "only those marked in the file"},
       needs_map_file},
      {path(reading, &HeightMapOptions::void_height_m),
       {.key = "void_height_m",
        .unit = "m",
        .low = -1e6,
        .high = 1e6,
        .help = "height to give to voids",
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
       {.key = "raw_type",
        .help = "sample type of a file without a header; by_name: .r16 is u16, .r32 is f32"},
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
        .help = "random seed: another seed gives other terrain of the same kind"},
       needs_generated_terrain},
      {path(fractal, &FractalParameters::posts),
       {.key = "posts", .low = 2.0, .high = 65536.0, .help = "posts along a side of generated terrain"},
       needs_generated_terrain},
      {path(fractal, &FractalParameters::side_m),
       {.key = "side_m",
        .unit = "m",
        .low = 1.0,
        .high = 1e7,
        .help = "length of a side of generated terrain"},
       needs_generated_terrain},
      {path(fractal, &FractalParameters::relief_m),
       {.key = "relief_m",
        .unit = "m",
        .low = 0.0,
        .high = 2e4,
        .help = "approximate height difference between the lowest and highest points of generated terrain"},
       needs_generated_terrain},
      {path(fractal, &FractalParameters::mean_m),
       {.key = "mean_m",
        .unit = "m",
        .low = -1e4,
        .high = 1e4,
        .help = "approximate mean of the lowest and highest heights of generated terrain"},
       needs_generated_terrain},
      {path(fractal, &FractalParameters::longest_m),
       {.key = "longest_m",
        .unit = "m",
        .low = 1.0,
        .high = 1e7,
        .help = "wavelength of the largest hills of generated terrain, at least a thousandth of its side"},
       needs_generated_terrain},
      {path(fractal, &FractalParameters::roughness),
       {.key = "roughness",
        .low = 0.2,
        .high = 0.8,
        .help = "height ratio of successive octaves of generated terrain: 0.2 smooth ... 0.8 jagged"},
       needs_generated_terrain},
      {path(fractal, &FractalParameters::erosion),
       {.key = "erosion", .low = 0.0, .high = 1.0, .help = "depth of the gullies cut into slopes: 0 none"},
       needs_generated_terrain},
      {path(fractal, &FractalParameters::island_radius_m),
       {.key = "island_radius_m",
        .unit = "m",
        .low = 1.0,
        .high = 1e7,
        .help = "make an island: generated terrain falls by relief_m from its middle to this distance",
        .example = "2000",
        .absent = "no island"},
       needs_generated_terrain},
  };
}

std::vector<Row<TerrainScene>> place_rows() {
  return {
      {&TerrainScene::origin_x_m,
       {.key = "origin_x_m",
        .unit = "m",
        .low = -1e6,
        .high = 1e6,
        .help = "position of the western posts, east of the origin",
        .example = "0",
        .absent = "the map's middle is at the origin"}},
      {&TerrainScene::origin_z_m,
       {.key = "origin_z_m",
        .unit = "m",
        .low = -1e6,
        .high = 1e6,
        .help = "position of the northern posts, south of the origin",
        .example = "0",
        .absent = "the map's middle is at the origin"}},
      {&TerrainScene::water_line_m,
       {.key = "water_line_m",
        .unit = "m",
        .low = -2e4,
        .high = 2e4,
        .help = "height up to which ground is painted as water, in scenes without a sea"},
       needs_no_sea},
      {&TerrainScene::tree_line_m,
       {.key = "tree_line_m",
        .unit = "m",
        .low = -2e4,
        .high = 2e4,
        .help = "height at which forest ends",
        .example = "1800",
        .absent = "from the file's latitude, else 2000"}},
      {&TerrainScene::snow_line_m,
       {.key = "snow_line_m",
        .unit = "m",
        .low = -2e4,
        .high = 2e4,
        .help = "height at which snow begins",
        .example = "2600",
        .absent = "from the file's latitude, else 2800"}},
      {&TerrainScene::colour,
       {.key = "colour",
        .help = "aerial picture of the ground (GeoTIFF, PNG, ...), placed by its georeference; stretched "
                "over the map if it has none",
        .example = "orthophoto.tif",
        .absent = "none: colours by height and slope",
        .rule = ParameterRule::file_name}},
      {choice(&TerrainScene::landscape, {"plain", "alpine", "desert", "tropical", "volcanic"}),
       {.key = "landscape", .help = "set of materials on the ground; materials of your own come on top"}},
      {&TerrainScene::relief,
       {.key = "relief",
        .low = 0.0,
        .high = 2.0,
        .help = "strength of the relief drawn between posts near the eye, 0 for none; queries ignore it"}},
      {&TerrainScene::finest_detail_m,
       {.key = "finest_detail_m",
        .unit = "m",
        .low = 0.0,
        .high = 1000.0,
        .help =
            "size of the smallest patterns of the ground; smaller ones show as their mean, 0 draws all, 120 "
            "is fastest",
        .slider = {{0.0, 120.0}}}},
      {choice(&TerrainScene::sky_visibility, {"off", "on"}),
       {.key = "sky_visibility",
        .help = "whether surrounding ground blocks light from the sky; adds a second or two at the start"},
       needs_whole_map},
  };
}

}  // namespace

Schema<TerrainScene> terrain_schema() {
  Schema<TerrainScene> schema("terrain");
  return schema.rows(ParameterGroup::terrain, Affects::heights, made_rows())
      .rows(ParameterGroup::height_map, Affects::heights, file_rows())
      .rows(ParameterGroup::terrain, Affects::cover, place_rows())
      .list(&TerrainScene::materials, max_materials, material_schema())
      .section(&TerrainScene::canopy, canopy_schema());
}

}  // namespace offing::scene
