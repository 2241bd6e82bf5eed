#include "mesh_tools/manifold.h"

#include <fmt/format.h>

#include "host/base/error.h"
#include "mesh_tools/mesh_defects.h"

namespace offing::mesh_tools {

void require_manifold(const TriangleMesh& mesh, std::string_view file_name) {
  const MeshDefects defects = find_index_defects(mesh);
  const bool is_manifold = defects.non_manifold_edges == 0 && defects.non_manifold_vertices == 0 &&
                           defects.turned_edges == 0 && defects.repeating_faces == 0;
  if (is_manifold) return;
  throw Error(
      ErrorKind::bad_input,
      fmt::format("{}: expected a manifold, got {} edges of more than two faces, {} vertices of more than "
                  "one fan, {} edges at which faces disagree, {} faces that repeat a vertex",
                  one_line(file_name), defects.non_manifold_edges, defects.non_manifold_vertices,
                  defects.turned_edges, defects.repeating_faces),
      "repair it with `offing-mesh repair`");
}

}  // namespace offing::mesh_tools
