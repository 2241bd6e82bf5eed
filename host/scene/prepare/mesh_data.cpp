#include "host/scene/prepare/mesh_data.h"

#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "host/io/meshes/mesh_sequence.h"
#include "host/io/meshes/prepared_mesh.h"
#include "host/io/meshes/read_mesh.h"
#include "host/mesh_shapes/shape_table.h"
#include "host/scene/model/named_file.h"

namespace offing::scene {

namespace {

struct Surface {
  TriangleMesh mesh;
  std::optional<VertexCurvatures> curvatures = {};
  Deformation deformation = {};
};

Surface read_surface(const MeshScene& mesh, Trust trust) {
  const bool is_sequence = is_mesh_sequence(mesh.file);
  if (!is_sequence && is_prepared(mesh.file)) {
    PreparedMesh prepared = read_prepared(mesh.file);
    return {std::move(prepared.mesh), std::move(prepared.curvatures)};
  }
  MeshFile file = is_sequence ? read_mesh_sequence(mesh.file, mesh.sequence_frames_per_s, trust)
                              : read_mesh_file(mesh.file, trust, mesh.animation);
  warn_of_left_out(mesh.file, file.report);
  return {std::move(file.mesh), {}, std::move(file.deformation)};
}

void scale_by(double scale, Surface& surface) {
  for (glm::dvec3& position_m : surface.mesh.positions_m) position_m *= scale;
  if (surface.deformation) {
    surface.deformation.form_at = [scale, form_at = std::move(surface.deformation.form_at)](double time_s) {
      MeshForm form = form_at(time_s);
      for (glm::dvec3& position_m : form.positions_m) position_m *= scale;
      return form;
    };
  }
  if (!surface.curvatures) return;
  for (double& k_per_m : surface.curvatures->k_max_per_m) k_per_m /= scale;
  for (double& k_per_m : surface.curvatures->k_min_per_m) k_per_m /= scale;
  for (double& area_m2 : surface.curvatures->area_m2) area_m2 *= scale * scale;
}

/// Plays a deformation again and again.
void repeat(Deformation& deformation) {
  if (!(deformation.end_s > 0.0)) return;
  deformation.form_at = [end_s = deformation.end_s, form_at = std::move(deformation.form_at)](double time_s) {
    return form_at(std::fmod(time_s, end_s));
  };
  deformation.end_s = std::numeric_limits<double>::infinity();
}

}  // namespace

MeshData mesh_data(const Scene& scene, std::size_t index) {
  const MeshScene& mesh = scene.meshes.at(index);
  Surface surface;
  if (mesh.file.empty()) {
    mesh_shapes::Shape shape =
        mesh_shapes::made_shape(mesh_shapes::shapes().at(mesh.shape), mesh.size_m, mesh.detail);
    surface = {std::move(shape.mesh), std::move(shape.truth)};
  } else {
    const std::vector<std::filesystem::path> sequence = files_of_mesh_sequence(mesh.file);
    surface = read_named(scene, {"mesh.file", {index, 0}}, "a mesh",
                         sequence.empty() ? mesh.file : sequence.front().string(),
                         [&] { return read_surface(mesh, scene.trust); });
  }
  scale_by(mesh.scale, surface);
  if (mesh.repeats == AnimationRepeats::on) repeat(surface.deformation);
  MeshData data{.mesh = std::make_shared<const TriangleMesh>(std::move(surface.mesh)),
                .curvatures = {},
                .deformation = std::move(surface.deformation)};
  if (surface.curvatures) {
    data.curvatures = std::make_shared<const VertexCurvatures>(std::move(*surface.curvatures));
  }
  return data;
}

}  // namespace offing::scene
