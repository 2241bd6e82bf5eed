// Bodies, clouds and meshes of a world.
#include <cstdint>

#include "handles.h"
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>

using namespace nb::literals;

namespace {

nb::dict body_poses(const World& of) {
  OffingWorld* const world = of.get();
  const std::size_t count = offing_body_count(world);
  auto place = new_array<double>({count, 3}), turn = new_array<double>({count, 4}),
       velocity = new_array<double>({count, 3}), spin = new_array<double>({count, 3}),
       displaced = new_array<double>({count});
  const OffingBodyPoses poses{sizeof poses,    place.data(), turn.data(),
                              velocity.data(), spin.data(),  displaced.data()};
  run([&] { return offing_read_body_poses(world, count, &poses); });
  nb::dict values;
  nb::list names;
  for (std::size_t i = 0; i < count; ++i) names.append(str_of(offing_body_name(world, i)));
  values["name"] = names;
  values["mass_centre_m"] = place;
  values["turn"] = turn;
  values["velocity_mps"] = velocity;
  values["spin_radps"] = spin;
  values["displaced_m3"] = displaced;
  return values;
}

nb::dict body_forces(const World& of) {
  OffingWorld* const world = of.get();
  const std::size_t count = offing_body_count(world);
  double time_s = 0.0;
  auto pressure = new_array<float>({count, 3}), pressure_moment = new_array<float>({count, 3}),
       drag = new_array<float>({count, 3}), drag_moment = new_array<float>({count, 3}),
       displaced = new_array<float>({count}), wetted = new_array<float>({count});
  constexpr std::size_t kinds = OFFING_FORCE_KINDS;
  std::vector<float> by_kind(count * kinds * 6);
  const OffingBodyForces forces{sizeof forces,          &time_s,       pressure.data(),
                                pressure_moment.data(), drag.data(),   drag_moment.data(),
                                displaced.data(),       wetted.data(), by_kind.data()};
  run([&] { return offing_read_body_forces(world, count, &forces); });
  nb::dict values;
  values["time_s"] = time_s;
  values["pressure_n"] = pressure;
  values["pressure_moment_nm"] = pressure_moment;
  values["drag_n"] = drag;
  values["drag_moment_nm"] = drag_moment;
  values["displaced_m3"] = displaced;
  values["wetted_m2"] = wetted;
  nb::dict named;
  for (std::size_t kind = 0; kind < kinds; ++kind) {
    auto force = new_array<float>({count, 6});
    for (std::size_t i = 0; i < count; ++i) {
      std::copy_n(by_kind.data() + (i * kinds + kind) * 6, 6, force.data() + i * 6);
    }
    named[offing_body_force_name(static_cast<int>(kind))] = force;
  }
  values["forces"] = named;
  return values;
}

nb::dict cloud_particles(const World& of) {
  OffingWorld* const world = of.get();
  const std::size_t count = offing_cloud_particle_count(world);
  auto place = new_array<double>({count, 3});
  auto radius = new_array<float>({count}), mass = new_array<float>({count}),
       albedo = new_array<float>({count, 3});
  auto cloud = new_array<std::uint32_t>({count}), id = new_array<std::uint32_t>({count});
  const OffingCloudParticles particles{sizeof particles, place.data(), radius.data(), mass.data(),
                                       albedo.data(),    cloud.data(), id.data()};
  run([&] { return offing_read_cloud_particles(world, count, &particles); });
  nb::dict values;
  values["place_m"] = place;
  values["radius_m"] = radius;
  values["optical_mass_m2"] = mass;
  values["albedo"] = albedo;
  values["cloud"] = cloud;
  values["id"] = id;
  return values;
}

nb::ndarray<nb::numpy, double> sample_clouds(const World& of, const Rows<3>& points_m, double cell_m) {
  auto extinction = new_array<double>({points_m.shape(0)});
  run([&] {
    return offing_sample_clouds(of.get(), cell_m, points_m.data(), points_m.shape(0), extinction.data());
  });
  return extinction;
}

nb::dict camera(const World& of) {
  OffingCamera found{};
  found.size = sizeof found;
  run([&] { return offing_get_camera(of.get(), &found); });
  nb::dict values;
  values["eye_m"] = nb::make_tuple(found.eye_m[0], found.eye_m[1], found.eye_m[2]);
  values["yaw_rad"] = found.yaw_rad;
  values["pitch_rad"] = found.pitch_rad;
  values["roll_rad"] = found.roll_rad;
  values["vertical_field_of_view_rad"] = found.vertical_field_of_view_rad;
  return values;
}

/// (rgba, distance) of the scene's camera.
nb::tuple draw_clouds(const World& of, int width_px, int height_px) {
  OffingCamera wanted{};
  wanted.size = sizeof wanted;
  run([&] { return offing_get_camera(of.get(), &wanted); });
  wanted.width_px = width_px;
  wanted.height_px = height_px;
  const std::size_t width = picture_side(width_px), height = picture_side(height_px);
  auto rgba = new_array<float>({height, width, 4}), distance = new_array<float>({height, width});
  run([&] { return offing_draw_clouds(of.get(), &wanted, rgba.data(), distance.data(), width * height); });
  return nb::make_tuple(rgba, distance);
}

nb::dict mesh_pose(const World& of, std::size_t mesh) {
  OffingMeshPose found{};
  found.size = sizeof found;
  run([&] { return offing_get_mesh_pose(of.get(), mesh, &found); });
  nb::dict values;
  values["name"] = str_of(offing_mesh_name(of.get(), mesh));
  values["position_m"] = nb::make_tuple(found.position_m[0], found.position_m[1], found.position_m[2]);
  values["turn"] = nb::make_tuple(found.turn[0], found.turn[1], found.turn[2], found.turn[3]);
  return values;
}

void find_highlights(const World& of, double first_s) {
  run([&] { return offing_find_highlights(of.get(), first_s); });
}

nb::dict highlights(const World& of, std::size_t mesh) {
  OffingWorld* const world = of.get();
  std::size_t count = 0;
  run([&] { return offing_count_highlights(world, mesh, &count); });
  auto id = new_array<std::uint64_t>({count});
  auto rule = new_array<std::int32_t>({count}), copy = new_array<std::int32_t>({count}),
       light = new_array<std::int32_t>({count}), texture = new_array<std::int32_t>({count});
  auto position = new_array<double>({count, 3}), right = new_array<double>({count, 3}),
       up = new_array<double>({count, 3}), normal = new_array<double>({count, 3}),
       width = new_array<double>({count}), height = new_array<double>({count}),
       opacity = new_array<double>({count}), softness = new_array<double>({count}),
       colour = new_array<double>({count, 3});
  const OffingHighlights found{sizeof found,   id.data(),       rule.data(),   copy.data(),
                               light.data(),   position.data(), right.data(),  up.data(),
                               normal.data(),  width.data(),    height.data(), opacity.data(),
                               texture.data(), softness.data(), colour.data()};
  run([&] { return offing_read_highlights(world, mesh, count, &found); });
  nb::dict values;
  values["id"] = id;
  values["rule"] = rule;
  values["copy"] = copy;
  values["light"] = light;
  values["position_m"] = position;
  values["right"] = right;
  values["up"] = up;
  values["normal"] = normal;
  values["width_m"] = width;
  values["height_m"] = height;
  values["opacity"] = opacity;
  values["texture"] = texture;
  values["softness"] = softness;
  values["colour"] = colour;
  return values;
}

}  // namespace

void bind_world_parts(nb::module_& module) {
  module.def("body_poses", body_poses, "world"_a);
  module.def("body_forces", body_forces, "world"_a);
  module.def(
      "cloud_count", [](const World& world) { return offing_cloud_count(world.get()); }, "world"_a);
  module.def("cloud_particles", cloud_particles, "world"_a);
  module.def("sample_clouds", sample_clouds, "world"_a, "points_m"_a, "cell_m"_a);
  module.def("camera", camera, "world"_a);
  module.def("draw_clouds", draw_clouds, "world"_a, "width_px"_a, "height_px"_a);
  module.def(
      "mesh_count", [](const World& world) { return offing_mesh_count(world.get()); }, "world"_a);
  module.def("mesh_pose", mesh_pose, "world"_a, "mesh"_a);
  module.def("find_highlights", find_highlights, "world"_a, "first_s"_a);
  module.def("highlights", highlights, "world"_a, "mesh"_a);
}
