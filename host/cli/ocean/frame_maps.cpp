#include "host/cli/ocean/frame_maps.h"

#include <array>
#include <utility>

#include <fmt/format.h>

namespace offing::cli {
namespace {

using Fields = BakedFrame::CascadeFields;
using Surface = ocean::SurfaceFields;
using Values = const std::vector<float>& (*)(const Fields&);

struct Component {
  std::string name;  // behind the map's; empty: the map has one
  Values values;
};

struct MapKind {
  ChannelGroup group;
  std::string_view name, unit;
  std::vector<Component> components;
};

template <auto member>
const std::vector<float>& surface_values(const Fields& fields) {
  return fields.surface.*member;
}
template <auto member>
const std::vector<float>& velocity_values(const Fields& fields) {
  return fields.velocity.*member;
}
template <auto member>
const std::vector<float>& normal_values(const Fields& fields) {
  return fields.normal.*member;
}
const std::vector<float>& foam_values(const Fields& fields) {
  return fields.foam;
}

/// `z` holds north where z is up: turn_z_up().
std::vector<Component> vector_of(MapAxes axes, Values x, Values y, Values z) {
  if (axes == MapAxes::z_up) std::swap(y, z);
  return {{"X", x}, {"Y", y}, {"Z", z}};
}

std::vector<MapKind> map_kinds(MapAxes axes) {
  using enum ChannelGroup;
  using ocean::VelocityFields;
  const std::string second = axes == MapAxes::z_up ? "Y" : "Z";  // horizontal axis
  return {
      {displacement, "displacement", "m",
       vector_of(axes, surface_values<&Surface::displacement_x>, surface_values<&Surface::displacement_y>,
                 surface_values<&Surface::displacement_z>)},
      {slope,
       "slope",
       "",
       {{"X", surface_values<&Surface::slope_x>}, {second, surface_values<&Surface::slope_z>}}},
      {gradient,
       "gradient",
       "",
       {{"XX", surface_values<&Surface::gradient_xx>},
        {"X" + second, surface_values<&Surface::gradient_xz>},
        {second + second, surface_values<&Surface::gradient_zz>}}},
      {jacobian, "jacobian", "", {{"", surface_values<&Surface::jacobian>}}},
      {jacobian, "jacobian_min_eigenvalue", "", {{"", surface_values<&Surface::jacobian_min_eigenvalue>}}},
      {foam, "foam", "", {{"", foam_values}}},
      {velocity, "velocity", "m/s",
       vector_of(axes, velocity_values<&VelocityFields::x>, velocity_values<&VelocityFields::y>,
                 velocity_values<&VelocityFields::z>)},
      {normal, "normal", "",
       vector_of(axes, normal_values<&NormalFields::x>, normal_values<&NormalFields::y>,
                 normal_values<&NormalFields::z>)},
  };
}

/// Of a wake window; `velocity` is that of its surface, upward.
std::vector<MapKind> wake_kinds(MapAxes axes) {
  using enum ChannelGroup;
  const std::string second = axes == MapAxes::z_up ? "Y" : "Z";
  return {{displacement, "height", "m", {{"", surface_values<&Surface::displacement_y>}}},
          {slope,
           "slope",
           "",
           {{"X", surface_values<&Surface::slope_x>}, {second, surface_values<&Surface::slope_z>}}},
          {velocity, "rise", "m/s", {{"", velocity_values<&ocean::VelocityFields::y>}}},
          {foam, "foam", "", {{"", foam_values}}}};
}

/// In `file`, its channels in the layer of this name.
BakedMap map_of(const MapKind& kind, FileLayout layout, std::size_t cascade, std::string file,
                const std::string& layer) {
  constexpr std::array rgb = {"R", "G", "B"};
  const bool is_rgb = layout == FileLayout::rgb;
  BakedMap map{
      .name = kind.name, .unit = kind.unit, .cascade = cascade, .file = std::move(file), .channels = {}};
  if (is_rgb) map.file += fmt::format("_{}", kind.name);
  for (std::size_t i = 0; i < kind.components.size(); ++i) {
    const Component& component = kind.components[i];
    std::string name =
        fmt::format("{}{}{}{}", layer, kind.name, component.name.empty() ? "" : ".", component.name);
    if (is_rgb) name = kind.components.size() == 1 ? "Y" : rgb[i];
    map.channels.push_back({std::move(name), component.values});
  }
  return map;
}

void negate_values(std::vector<float>& values) {
  for (float& value : values) value = -value;
}

/// (x, y, z) to (x, -z, y).
void turn_vectors(std::vector<float>& vectors) {
  for (std::size_t i = 0; i + 2 < vectors.size(); i += 3) {
    std::swap(vectors[i + 1], vectors[i + 2]);
    vectors[i + 1] = -vectors[i + 1];
  }
}

}  // namespace

std::vector<BakedMap> baked_maps(const BakeSettings& settings, std::size_t cascades) {
  const std::vector<MapKind> kinds = map_kinds(settings.axes);
  std::vector<BakedMap> maps;
  const bool is_combined = settings.layout == FileLayout::combined;
  for (std::size_t cascade = 0; cascade < cascades; ++cascade) {
    for (const MapKind& kind : kinds) {
      if (!settings.has(kind.group)) continue;
      maps.push_back(map_of(kind, settings.layout, cascade,
                            is_combined ? "ocean" : fmt::format("ocean.c{}", cascade),
                            is_combined ? fmt::format("c{}.", cascade) : ""));
    }
  }
  for (std::size_t window = 0; window < settings.wake_cells.size(); ++window) {
    for (const MapKind& kind : wake_kinds(settings.axes)) {
      const bool has_file = settings.layout != FileLayout::rgb || kind.components.size() == 1;
      if (settings.has(kind.group) && has_file) {
        maps.push_back(
            map_of(kind, settings.layout, cascades + window, fmt::format("ocean.w{}", window), ""));
      }
    }
  }
  return maps;
}

void require_maps(const BakeSettings& settings) {
  if (settings.layout != FileLayout::rgb || !settings.has(ChannelGroup::slope)) return;
  throw bad_argument("--channels", "maps of one or three channels with --layout rgb", "slope",
                     "displacement,foam,normal");
}

void turn_z_up(BakedFrame& frame) {
  for (std::size_t i = 0; i < frame.cascades.size() + frame.wakes.size(); ++i) {
    Fields& fields = frame.written(i);
    for (std::vector<float>* values : {&fields.surface.displacement_z, &fields.surface.slope_z,
                                       &fields.surface.gradient_xz, &fields.velocity.z, &fields.normal.z}) {
      negate_values(*values);
    }
  }
  turn_vectors(frame.mesh.positions_xyz);
  turn_vectors(frame.mesh.normals_xyz);
}

}  // namespace offing::cli
