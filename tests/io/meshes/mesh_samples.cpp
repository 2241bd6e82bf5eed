#include "tests/io/meshes/mesh_samples.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>
#include <random>
#include <stdexcept>

#include "host/io/meshes/gltf_mesh.h"
#include "host/io/meshes/obj_mesh.h"
#include "host/io/meshes/off_mesh.h"
#include "host/io/meshes/ply_mesh.h"
#include "host/io/meshes/stl_mesh.h"

namespace offing::test {

std::vector<MeshSample> mesh_samples() {
  std::vector<MeshSample> samples;
  for (const std::string format : {"gltf", "obj", "off", "ply", "stl"}) {
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(OFFING_CORPUS) / format)) {
      std::ifstream file(entry.path(), std::ios::binary);
      samples.push_back(
          {format, entry.path().filename().string(), {std::istreambuf_iterator<char>(file), {}}});
    }
  }
  return samples;
}

MeshSample mesh_sample(const std::string& format, const std::string& name) {
  for (MeshSample& sample : mesh_samples()) {
    if (sample.format == format && sample.name == name) return std::move(sample);
  }
  throw std::runtime_error("no sample " + format + "/" + name);
}

MeshFile parse_mesh(std::string_view format, std::string_view bytes) {
  if (format == "gltf") return meshes::parse_gltf(bytes, "/nowhere/test");
  if (format == "obj") return meshes::parse_obj(bytes, "test");
  if (format == "off") return meshes::parse_off(bytes, "test");
  if (format == "ply") return meshes::parse_ply(bytes, "test").file;
  return meshes::parse_stl(bytes, "test");
}

std::size_t left_out(const MeshFile& file, std::string_view what) {
  const auto found = std::find_if(file.report.left_out.begin(), file.report.left_out.end(),
                                  [&](const LeftOut& item) { return item.what == what; });
  return found == file.report.left_out.end() ? 0 : found->count;
}

TriangleMesh random_mesh(unsigned seed, unsigned rings, unsigned sectors) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> radius_m(0.8, 1.2);
  TriangleMesh mesh;
  const auto add = [&](double polar, double azimuth) {
    mesh.positions_m.push_back(radius_m(random) * glm::dvec3(std::sin(polar) * std::cos(azimuth),
                                                             std::cos(polar),
                                                             std::sin(polar) * std::sin(azimuth)));
  };
  add(0.0, 0.0);
  for (unsigned ring = 0; ring < rings; ++ring) {
    for (unsigned sector = 0; sector < sectors; ++sector) {
      add(std::numbers::pi * (ring + 1) / (rings + 1), 2.0 * std::numbers::pi * sector / sectors);
    }
  }
  add(std::numbers::pi, 0.0);
  const auto at = [&](unsigned ring, unsigned sector) { return 1 + ring * sectors + sector % sectors; };
  const unsigned south = 1 + rings * sectors;
  for (unsigned sector = 0; sector < sectors; ++sector) {
    mesh.faces.push_back({0, at(0, sector + 1), at(0, sector)});
    for (unsigned ring = 0; ring + 1 < rings; ++ring) {
      mesh.faces.push_back({at(ring, sector), at(ring, sector + 1), at(ring + 1, sector)});
      mesh.faces.push_back({at(ring, sector + 1), at(ring + 1, sector + 1), at(ring + 1, sector)});
    }
    mesh.faces.push_back({at(rings - 1, sector), at(rings - 1, sector + 1), south});
  }
  return mesh;
}

}  // namespace offing::test
