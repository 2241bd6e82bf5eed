#include "present/window/dropped_files.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/io/file_extension.h"
#include "host/io/meshes/ply_reader.h"
#include "host/io/tile_store/tile_store.h"
#include "host/scene/schema/parameter_table.h"
#include "host/scene/schema/scene_elements.h"
#include "present/editing/objects/scene_objects.h"

namespace offing::present {
namespace {

struct KnownName {
  std::string_view extension;
  DroppedKind kind;
};

// What the readers of host/io take, as far as a name tells; .ply is either of two.
constexpr std::array known_names{
    KnownName{".toml", DroppedKind::scene},     KnownName{".obj", DroppedKind::mesh},
    KnownName{".off", DroppedKind::mesh},       KnownName{".stl", DroppedKind::mesh},
    KnownName{".gltf", DroppedKind::mesh},      KnownName{".glb", DroppedKind::mesh},
    KnownName{".tif", DroppedKind::height_map}, KnownName{".tiff", DroppedKind::height_map},
    KnownName{".hgt", DroppedKind::height_map}, KnownName{".zip", DroppedKind::height_map},
    KnownName{".dem", DroppedKind::height_map}, KnownName{".asc", DroppedKind::height_map},
    KnownName{".vrt", DroppedKind::height_map}, KnownName{".png", DroppedKind::height_map},
    KnownName{".exr", DroppedKind::height_map}, KnownName{".data_spec", DroppedKind::spectrum},
    KnownName{".spec", DroppedKind::spectrum},  KnownName{".spc", DroppedKind::spectrum},
    KnownName{".spt", DroppedKind::spectrum},   KnownName{".txt", DroppedKind::spectrum},
    KnownName{".nc", DroppedKind::spectrum},    KnownName{".gz", DroppedKind::spectrum},
    KnownName{".csv", DroppedKind::spectrum},   KnownName{".json", DroppedKind::spectrum},
    KnownName{".vdb", DroppedKind::cloud}};

DroppedKind kind_of_ply(const std::filesystem::path& file) {
  constexpr std::size_t most_bytes = 1 << 16;  // of a header
  std::string head(most_bytes, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(std::max<std::streamsize>(stream.gcount(), 0)));
  const meshes::PlyHeader header = meshes::parse_ply_header(head, file.string());
  const auto has_mass = [](const meshes::PlyElement& element) {
    return std::ranges::find(element.properties, "optical_mass", &meshes::PlyProperty::name) !=
           element.properties.end();
  };
  return std::ranges::any_of(header.elements, has_mass) ? DroppedKind::cloud : DroppedKind::mesh;
}

/// Stores text as if the scene's file had it.
void store_text(scene::Scene& scene, const char* key, const std::string& text,
                scene::ElementIndex element = {}) {
  scene::store(scene, *scene::find_parameter(key), {.value = text, .shown = one_line(text)}, {.subject = key},
               element);
}

scene::ElementIndex add_element(scene::Scene& scene, const char* key) {
  const scene::Parameter& row = *scene::find_parameter(key);
  scene::append_element(scene, row, {.subject = std::string(scene::section_of(key))});
  return scene::last_element(scene, *row.section);
}

std::string add_mesh(scene::Scene& scene, const std::filesystem::path& file, const glm::dvec3& place_m) {
  const std::string name = unused_name(scene.meshes, file.stem().string());
  const scene::ElementIndex element = add_element(scene, "mesh.file");
  store_text(scene, "mesh.file", file.string(), element);
  store_text(scene, "mesh.name", name, element);
  scene.meshes[element.outer].position_m = place_m;
  return fmt::format("added the mesh {}: its place and scale are in the list Objects", name);
}

std::string add_cloud(scene::Scene& scene, const std::filesystem::path& file) {
  const std::string name = unused_name(scene.clouds, file.stem().string());
  const scene::ElementIndex element = add_element(scene, "cloud.file");
  store_text(scene, "cloud.file", file.string(), element);
  store_text(scene, "cloud.name", name, element);
  return fmt::format("added the cloud {}: its place and look are in the list Objects", name);
}

std::string take_heights(scene::Scene& scene, const std::filesystem::path& file) {
  scene.terrain.is_given = true;
  // How the last file was read, and where it lay, says nothing about this one.
  scene.terrain.reading = {};
  scene.terrain.origin_x_m.reset();
  scene.terrain.origin_z_m.reset();
  scene.terrain.colour.clear();
  store_text(scene, "terrain.file", file.string());
  return fmt::format("the terrain now comes from {}; X looks at it", file.filename().string());
}

std::string take_spectrum(scene::Scene& scene, const std::filesystem::path& file) {
  scene.ocean.is_given = true;
  scene.ocean.record = 0;
  store_text(scene, "ocean.spectrum_file", file.string());
  return fmt::format("the sea now comes from {}, record 0", file.filename().string());
}

}  // namespace

bool may_be(const std::filesystem::path& file, DroppedKind kind) {
  const std::string extension = lower_extension(file);
  if (extension == ".ply") return kind == DroppedKind::mesh || kind == DroppedKind::cloud;
  const auto* known = std::ranges::find(known_names, std::string_view(extension), &KnownName::extension);
  if (known != known_names.end() && known->kind == kind) return true;
  return kind == DroppedKind::height_map && is_tile_store(file);
}

DroppedKind kind_of_dropped(const std::filesystem::path& file) {
  std::error_code unknown;
  if (!std::filesystem::exists(file, unknown)) {
    throw Error(ErrorKind::bad_input, fmt::format("{}: cannot be found", one_line(file.string())),
                "drop a file of this machine");
  }
  if (is_tile_store(file)) return DroppedKind::height_map;
  const std::string extension = lower_extension(file);
  if (extension == ".ply") return kind_of_ply(file);
  const auto* known = std::ranges::find(known_names, std::string_view(extension), &KnownName::extension);
  if (known != known_names.end()) return known->kind;
  throw Error(
      ErrorKind::bad_input,
      fmt::format("{}: expected a scene, a mesh, heights, a spectrum or a cloud, got a file of another kind",
                  one_line(file.filename().string())),
      "known endings: .toml; .obj .ply .off .stl .gltf .glb; .tif .hgt .zip .dem .asc .vrt .png .exr and "
      "tile stores; .data_spec .spec .spc .spt .txt .csv .json .nc and these as .gz; .vdb and .ply of "
      "particles");
}

std::string add_dropped(scene::Scene& scene, const std::filesystem::path& file, DroppedKind kind,
                        const glm::dvec3& place_m) {
  // Beside what stands alone a sea has to be named.
  scene.ocean.is_given = scene.has_sea();
  switch (kind) {
    case DroppedKind::mesh:
      return add_mesh(scene, file, place_m);
    case DroppedKind::height_map:
      return take_heights(scene, file);
    case DroppedKind::spectrum:
      return take_spectrum(scene, file);
    case DroppedKind::cloud:
      return add_cloud(scene, file);
    case DroppedKind::scene:
      break;  // which is opened
  }
  return {};
}

}  // namespace offing::present
