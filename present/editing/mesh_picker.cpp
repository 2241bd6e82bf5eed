#include "present/editing/mesh_picker.h"

#include <algorithm>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace offing::present {
namespace {

constexpr double reach = 2.0;  // half widths

/// The one of a mesh that a place of it, in its axes, belongs to.
const highlights::DrawnHighlight* nearest_highlight(const world::WorldMesh& mesh, const glm::dvec3& place_m,
                                                    const glm::dvec3& face_normal) {
  const highlights::DrawnHighlight* nearest = nullptr;
  double least = reach;
  for (const highlights::DrawnHighlight& highlight : mesh.highlights()) {
    // Not those of the other side of something thin.
    if (glm::dot(highlight.projector.normal, face_normal) <= 0.0) continue;
    const double distance =
        glm::length(glm::dvec3(highlights::projection_of(highlight.projector) * glm::dvec4(place_m, 1.0)));
    if (distance >= least) continue;
    least = distance;
    nearest = &highlight;
  }
  return nearest;
}

}  // namespace

const highlights::DrawnHighlight* find_highlight(const std::vector<world::WorldMesh>& meshes,
                                                 const HighlightName& name) {
  if (name.mesh >= meshes.size()) return nullptr;
  const highlights::DrawnHighlight* found = nullptr;
  for (const highlights::DrawnHighlight& highlight : meshes[name.mesh].highlights()) {
    if (highlight.id == name.id && (found == nullptr || highlight.opacity > found->opacity))
      found = &highlight;
  }
  return found;
}

void MeshPicker::prepare(const std::vector<world::WorldMesh>& meshes) {
  if (trees_.size() > meshes.size())
    trees_.erase(trees_.begin() + static_cast<std::ptrdiff_t>(meshes.size()), trees_.end());
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    if (i < trees_.size() && trees_[i].revision == meshes[i].revision()) continue;
    Tree tree{meshes[i].revision(), highlights::FaceTree(meshes[i].surface().mesh())};
    if (i < trees_.size()) {
      trees_[i] = std::move(tree);
    } else {
      trees_.push_back(std::move(tree));
    }
  }
}

std::optional<MeshHit> MeshPicker::hit(const std::vector<world::WorldMesh>& meshes, const Camera& camera,
                                       glm::dvec2 clip) {
  prepare(meshes);
  std::optional<MeshHit> first;
  const glm::dvec3 way = glm::normalize(ray_direction(camera, clip));
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    if (!meshes[i].is_visible()) continue;
    const highlights::RigidMotion& motion = meshes[i].motion();
    const glm::dmat3 inverse = glm::transpose(motion.rotation);
    const glm::dvec3 origin_m = inverse * (camera.eye_m - motion.translation_m);
    const glm::dvec3 direction = inverse * way;
    const std::optional<highlights::FaceHit> hit = trees_[i].tree.first_hit(origin_m, direction, least);
    if (!hit) continue;
    least = hit->distance;
    const highlights::DrawnHighlight* highlight = nearest_highlight(
        meshes[i], origin_m + hit->distance * direction, meshes[i].surface().face_normals()[hit->face]);
    first = MeshHit{i, hit->distance};
    if (highlight != nullptr) first->highlight = HighlightName{i, highlight->id};
  }
  return first;
}

}  // namespace offing::present
