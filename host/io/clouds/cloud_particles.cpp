#include "host/io/clouds/cloud_particles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <glm/common.hpp>

#include "host/io/meshes/mesh_bytes.h"
#include "host/io/meshes/ply_reader.h"
#include "host/io/meshes/ply_writer.h"
#include "host/io/meshes/text_lines.h"

namespace offing {
namespace {

using meshes::PlyElement;
using meshes::PlyHeader;
using meshes::PlyValues;

/// What a value must be.
enum class Range { any, above_zero, from_zero, share, texture, whole };

struct Column {
  std::string_view name;
  std::string_view type;
  Range range;
  std::optional<double> absent;  ///< none: it must be there
};

constexpr double own_number = -1.0;  // stands for the number of the particle

constexpr std::array<Column, 12> columns{{{"x", "double", Range::any, {}},
                                          {"y", "double", Range::any, {}},
                                          {"z", "double", Range::any, {}},
                                          {"radius", "float", Range::above_zero, {}},
                                          {"optical_mass", "float", Range::from_zero, {}},
                                          {"red", "float", Range::share, 1.0},
                                          {"green", "float", Range::share, 1.0},
                                          {"blue", "float", Range::share, 1.0},
                                          {"turn", "float", Range::any, 0.0},
                                          {"texture", "uint", Range::texture, 0.0},
                                          {"cloud", "uint", Range::whole, 0.0},
                                          {"id", "uint", Range::whole, own_number}}};
using Row = std::array<double, columns.size()>;

std::string_view text_of(Range range) {
  switch (range) {
    case Range::any:
      return "finite";
    case Range::above_zero:
      return "above 0";
    case Range::from_zero:
      return "from 0 on";
    case Range::share:
      return "within 0 ... 1";
    case Range::texture:
      return "below 32";
    case Range::whole:
      return "a whole number below 2^32";
  }
  return "";
}

bool is_within(Range range, double value) {
  // Beyond that, floats of the device overflow.
  if (!(std::abs(value) < std::numeric_limits<float>::max())) return false;
  const bool is_whole = value == std::floor(value) && value >= 0.0;
  switch (range) {
    case Range::any:
      return true;
    case Range::above_zero:
      return static_cast<float>(value) > 0.0f;
    case Range::from_zero:
      return value >= 0.0;
    case Range::share:
      return value >= 0.0 && value <= 1.0;
    case Range::texture:
      return is_whole && value < 2 * CLOUD_TEXTURES;
    case Range::whole:
      return is_whole && value <= std::numeric_limits<std::uint32_t>::max();
  }
  return false;
}

class ParticleParser {
 public:
  ParticleParser(std::string_view bytes, std::string_view file_name)
      : file_name_(file_name),
        header_(meshes::parse_ply_header(bytes, file_name)),
        values_(bytes, file_name, header_) {}

  std::vector<Row> parse() {
    std::vector<Row> rows;
    for (const PlyElement& element : header_.elements) {
      values_.at(element.name, 0);
      values_.require_room(element);
      if (element.name == "vertex") {
        read_vertices(element, rows);
      } else {
        pass_over(element);
      }
    }
    if (rows.empty()) throw meshes::mesh_error(file_name_, 0, "particles", "none");
    return rows;
  }

 private:
  /// Which column each property of a vertex goes to; columns.size() for those that nobody needs.
  std::vector<std::size_t> find_columns(const PlyElement& element) const {
    std::vector<std::size_t> targets;
    for (const meshes::PlyProperty& property : element.properties) {
      const auto is_it = [&](const Column& column) { return column.name == property.name; };
      const auto found =
          property.count_type ? columns.end() : std::find_if(columns.begin(), columns.end(), is_it);
      targets.push_back(static_cast<std::size_t>(found - columns.begin()));
    }
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (!columns[i].absent && std::find(targets.begin(), targets.end(), i) == targets.end()) {
        throw meshes::mesh_error(file_name_, 0, fmt::format("particles with a property {}", columns[i].name),
                                 "no property of this name");
      }
    }
    return targets;
  }

  void read_vertices(const PlyElement& element, std::vector<Row>& rows) {
    const std::vector<std::size_t> targets = find_columns(element);
    if (element.count > most_cloud_particles) {
      values_.fail(fmt::format("at most {} particles", most_cloud_particles),
                   fmt::format("{}", element.count));
    }
    rows.reserve(element.count);
    for (std::size_t i = 0; i < element.count; ++i) {
      values_.at(element.name, i);
      Row row{};
      for (std::size_t c = 0; c < columns.size(); ++c) {
        const double absent = columns[c].absent.value_or(0.0);
        row[c] = absent == own_number ? static_cast<double>(i) : absent;
      }
      for (std::size_t p = 0; p < targets.size(); ++p) read_value(element.properties[p], targets[p], row);
      rows.push_back(row);
    }
  }

  void read_value(const meshes::PlyProperty& property, std::size_t column, Row& row) {
    if (column == columns.size()) {
      values_.skip(property);
      return;
    }
    const double value = values_.next(property.type);
    if (!is_within(columns[column].range, value)) {
      values_.fail(fmt::format("{} {}", columns[column].name, text_of(columns[column].range)),
                   fmt::format("{:g}", value));
    }
    row[column] = value;
  }

  void pass_over(const PlyElement& element) {
    for (std::size_t i = 0; i < element.count; ++i) {
      values_.at(element.name, i);
      for (const meshes::PlyProperty& property : element.properties) values_.skip(property);
    }
  }

  std::string file_name_;
  PlyHeader header_;
  PlyValues values_;
};

CloudParticle particle_of(const Row& row, const glm::dvec3& origin_m) {
  const auto narrow = [&](std::size_t column) { return static_cast<float>(row[column]); };
  const auto whole = [&](std::size_t column) { return static_cast<unsigned int>(row[column]); };
  return {.x = static_cast<float>(row[0] - origin_m.x),
          .y = static_cast<float>(row[1] - origin_m.y),
          .z = static_cast<float>(row[2] - origin_m.z),
          .radius = narrow(3),
          .optical_mass = narrow(4),
          .red = narrow(5),
          .green = narrow(6),
          .blue = narrow(7),
          .texture = whole(9),
          .cloud = whole(10),
          .id = whole(11),
          .turn = narrow(8)};
}

glm::dvec3 middle_of(const std::vector<Row>& rows) {
  glm::dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
  for (const Row& row : rows) {
    const glm::dvec3 place_m(row[0], row[1], row[2]);
    low = glm::min(low, place_m);
    high = glm::max(high, place_m);
  }
  constexpr double step_m = 1024.0;  // of origins: floats hold multiples of it exactly
  return step_m * glm::floor(0.5 * (low + high) / step_m + 0.5);
}

}  // namespace

void write_cloud_particles(const std::filesystem::path& path, const ParticleCloud& cloud, Existing existing) {
  std::vector<meshes::PlyColumn> written;
  for (const Column& column : columns) written.push_back({column.type, std::string(column.name)});
  meshes::PlyWriter writer(
      path, {"particles of clouds: x y z and radius in m, +y up; optical_mass in m^2; turn in rad"}, written,
      {.vertices = cloud.particles.size(), .faces = 0}, existing);
  for (const CloudParticle& particle : cloud.particles) {
    writer.put(cloud.origin_m.x + particle.x);
    writer.put(cloud.origin_m.y + particle.y);
    writer.put(cloud.origin_m.z + particle.z);
    for (const float value : {particle.radius, particle.optical_mass, particle.red, particle.green,
                              particle.blue, particle.turn}) {
      writer.put(value);
    }
    for (const std::uint32_t value : {particle.texture, particle.cloud, particle.id}) writer.put(value);
  }
  writer.commit();
}

ParticleCloud read_cloud_particles(const std::filesystem::path& path) {
  const std::vector<Row> rows = meshes::parse_mesh_file(
      path, [&](std::string_view bytes) { return ParticleParser(bytes, path.string()).parse(); });
  ParticleCloud cloud{.origin_m = middle_of(rows), .particles = {}};
  cloud.particles.reserve(rows.size());
  for (const Row& row : rows) cloud.particles.push_back(particle_of(row, cloud.origin_m));
  return cloud;
}

}  // namespace offing
