// Writes the files that fuzzers of binary formats start from, small ones by our own writers.
// Usage: make_corpus FOLDER SCENES

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <numeric>
#include <string>
#include <vector>

#include "host/io/atomic_file.h"
#include "host/io/clouds/cloud_particles.h"
#include "host/io/exr_image.h"
#include "host/io/height_maps/map_features.h"
#include "host/io/height_maps/new_raster.h"
#include "host/io/png_image.h"
#include "host/io/tile_store/tile_file.h"
#include "host/io/tile_store/tile_store.h"
#include "host/io/vdb/vdb_volume.h"
#include "host/io/whole_file.h"

namespace {

namespace fs = std::filesystem;
using namespace offing;  // NOLINT(google-build-using-namespace)

constexpr int columns = 6, rows = 5;

std::vector<float> ramp() {
  std::vector<float> values(columns * rows);
  std::iota(values.begin(), values.end(), -3.5f);
  return values;
}

fs::path folder_of(const fs::path& corpus, const char* reader) {
  fs::create_directories(corpus / reader);
  return corpus / reader;
}

void make_exr(const fs::path& folder) {
  const std::vector<float> values = ramp();
  const ExrImage image{
      .width = columns,
      .height = rows,
      .channels = {{"c0.displacement.X", values}, {"height", values}},
      .attributes = {
          {"offing.scene_hash", std::string("0123")}, {"offing.time_s", 1.5}, {"offing.frame", 36}}};
  write_exr(folder / "none", image, PixelType::float_32, ExrCompression::none);
  write_exr(folder / "zips", image, PixelType::half_16, ExrCompression::zips);
  write_exr(folder / "zip", image, PixelType::float_32, ExrCompression::zip);
  write_exr(folder / "piz", image, PixelType::half_16, ExrCompression::piz);
}

RgbImage picture() {
  RgbImage image{columns, rows, std::vector<std::uint8_t>(3 * columns * rows)};
  std::iota(image.rgb.begin(), image.rgb.end(), std::uint8_t{7});
  return image;
}

void make_png(const fs::path& folder) {
  write_png(folder / "rgb", picture());
  const std::vector<std::uint8_t> rgba(4 * columns * rows, 90);
  write_file_atomically(folder / "rgba", png_bytes({columns, rows, rgba}));
}

void make_rasters(const fs::path& folder) {
  const auto heights = create_height_raster(folder / "heights", columns, rows, 30.0);
  heights->add_rows(ramp());
  heights->commit();
  const std::vector<std::uint8_t> bytes(columns * rows, 3);
  write_byte_raster(folder / "bytes",
                    {.columns = columns, .rows = rows, .values = bytes, .georeference = {}, .nodata = 3});
  write_png(folder / "picture", picture());
  write_file_atomically(
      folder / "grid",
      "ncols 3\nnrows 2\nxllcorner 500000\nyllcorner 4000000\ncellsize 30\nNODATA_value -9999\n"
      "1 2.5 3\n-9999 5 6\n");
  write_file_atomically(folder / "whole_grid",
                        "ncols 2\nnrows 2\nxllcenter 0\nyllcenter 0\ncellsize 1\n1 2\n3 4\n");
}

void make_vdb(const fs::path& folder) {
  VdbCloud cloud;
  cloud.volume.cell_m = 20.0;
  cloud.volume.origin_m = {-160.0, 500.0, 0.0};
  cloud.volume.bricks = {2, 1, 1};
  cloud.volume.extinction_per_m = 0.05;
  cloud.volume.brick_of = {CloudVolume::no_brick, 0};
  cloud.volume.density.assign(CloudVolume::cells_of_brick, 0.0f);
  std::fill_n(cloud.volume.density.begin() + 100, 30, 0.25f);
  write_vdb(folder / "half", cloud, VdbPrecision::half);
  write_vdb(folder / "single", cloud);
  cloud.albedo.assign(CloudVolume::cells_of_brick, {1.0f, 0.9f, 0.5f});
  write_vdb(folder / "coloured", cloud);
}

void make_clouds(const fs::path& folder) {
  ParticleCloud cloud;
  cloud.particles = {
      {.x = 1, .y = 2, .z = 3, .radius = 4, .optical_mass = 5, .red = 1, .green = 1, .blue = 1},
      {.x = -1,
       .y = 2,
       .z = 3,
       .radius = 2,
       .optical_mass = 0,
       .red = 0,
       .green = 0.5,
       .blue = 1,
       .texture = 3,
       .cloud = 1,
       .id = 1,
       .turn = 2}};
  write_cloud_particles(folder / "particles", cloud);
  write_file_atomically(
      folder / "text",
      "ply\nformat ascii 1.0\ncomment of others\nelement vertex 2\nproperty float x\nproperty float y\n"
      "property float z\nproperty float radius\nproperty float optical_mass\n"
      "property list uchar int rest\nend_header\n0 1 2 3 4 0\n5 6 7 8 9 2 1 2\n");
}

/// The header of a tile's file and what follows, cut off: tile_fuzzer.cpp repeats it.
void make_tiles(const fs::path& folder) {
  HeightTile tile;
  tile.means_m.resize(std::size_t{ringed_tile_posts} * ringed_tile_posts);
  tile.highest_m.resize(std::size_t{tile_posts} * tile_posts);
  std::iota(tile.means_m.begin(), tile.means_m.end(), -500.0f);
  std::iota(tile.highest_m.begin(), tile.highest_m.end(), 0.25f);
  const auto write = [&](const char* name) {
    write_file_atomically(folder / name, std::string(1, '\0') + tile_store::encode_tile(tile).substr(0, 128));
  };
  write("heights");
  tile.is_void.assign(tile.highest_m.size(), 1);
  write("voids");
  std::fill(tile.means_m.begin(), tile.means_m.end(), 12.0f);
  std::fill(tile.highest_m.begin(), tile.highest_m.end(), 12.0f);
  write("level");
}

void make_store(const fs::path& folder, const fs::path& work) {
  const TileSetShape shape = TileSetShape::of(600, 300);
  TileStoreWriter(work, Existing::keep)
      .finish({.shape = shape,
               .highest_m = 10.0f,
               .georeference = {"LOCAL_CS[\"a\"]", 0.0, 0.0, 30.0, -30.0},
               .centre_latitude_deg = 46.0,
               .centre_longitude_deg = 7.0});
  fs::rename(work / "store.toml", folder / "header");
  fs::remove_all(work);
}

void make_tables(const fs::path& folder) {
  write_file_atomically(folder / "plain", std::string(1, '\1') + "1,2\n# a remark\n\n-3.5e2, +4\r\n");
  write_file_atomically(folder / "named",
                        std::string(1, '\x0e') + "name,height_m,z_m,x_m\nhere,1,2,3\nthere,4,5,6\n");
}

/// Texts and calls without a format of their own.
void make_texts(const fs::path& corpus) {
  const fs::path cameras = folder_of(corpus, "camera");
  write_file_atomically(cameras / "fly", "fly\n1280x720\n0:12\n2/3\n");
  write_file_atomically(cameras / "walk", "walk\n1x16384\n7\n1/1\n");
  write_file_atomically(cameras / "place", "500,300.5,9e2,-720,-15\n16x16\n9999999\n100000/100000\n");
  const fs::path entries = folder_of(corpus, "cache");
  write_file_atomically(entries / "stored", std::string("\2\7\0a binary", 11));
  write_file_atomically(entries / "file", "\1OFFPROG\nnot long enough");
  const fs::path calls = folder_of(corpus, "c");
  std::string bytes;
  for (int i = 0; i < 400; ++i) bytes += static_cast<char>(i * 37 % 251);
  write_file_atomically(calls / "calls", bytes);
  write_file_atomically(calls / "scene", "version = 1\n[ocean]\nsize = 16\n\\\3");
}

/// The first byte is the format and the shape that features_fuzzer.cpp takes.
void make_features(const fs::path& folder) {
  const fs::path package = folder / "points";
  const auto writer = create_features(
      package, {.shape = FeatureShape::points,
                .layer = "wells",
                .coordinate_system = "EPSG:4326",
                .has_heights = true,
                .columns = {{"name", AttributeKind::text}, {"height_m", AttributeKind::number}}});
  writer->add(std::vector{glm::dvec3(-70.5, -32.5, 90.0)}, std::vector<AttributeValue>{"a", 1.5});
  writer->commit();
  write_file_atomically(package, "\1" + read_whole_file(package, {"a GeoPackage", 1 << 20}));
  write_file_atomically(
      folder / "json",
      std::string(1, '\0') +
          R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{"a":1,)"
          R"("b":"c","d":null,"e":[1.5]},"geometry":{"type":"Point","coordinates":[-70,-32,9]}}]})");
  write_file_atomically(folder / "lines",
                        "\2"
                        R"({"type":"MultiLineString","coordinates":[[[-70.5,-32],[1e1,2]]]})");
}

}  // namespace

int main(int, char** arguments) {
  const fs::path corpus(arguments[1]);
  make_exr(folder_of(corpus, "exr"));
  make_png(folder_of(corpus, "png"));
  make_features(folder_of(corpus, "features"));
  make_rasters(folder_of(corpus, "raster"));
  make_vdb(folder_of(corpus, "vdb"));
  make_clouds(folder_of(corpus, "cloud"));
  make_tiles(folder_of(corpus, "tile"));
  make_store(folder_of(corpus, "store"), corpus / "unfinished_store");
  make_tables(folder_of(corpus, "table"));
  make_texts(corpus);
  for (const fs::directory_entry& scene : fs::directory_iterator(arguments[2])) {
    if (scene.path().extension() == ".toml")
      fs::copy(scene.path(), folder_of(corpus, "scene") / scene.path().filename(),
               fs::copy_options::update_existing);
  }
}
