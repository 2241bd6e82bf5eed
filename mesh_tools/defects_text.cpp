#include "mesh_tools/defects_text.h"

#include <fmt/format.h>

#include "host/base/error.h"

namespace offing::mesh_tools {

namespace {

std::string line(std::string_view label, std::string_view text) {
  return fmt::format("  {:<22} {}\n", label, text);
}

std::string line(std::string_view label, std::size_t count) {
  return line(label, fmt::format("{}", count));
}

}  // namespace

nlohmann::ordered_json to_json(const MeshDefects& defects) {
  return {{"vertices", defects.vertices},
          {"faces", defects.faces},
          {"components", defects.components},
          {"boundary_loops", defects.boundary_loops},
          {"non_manifold_edges", defects.non_manifold_edges},
          {"non_manifold_vertices", defects.non_manifold_vertices},
          {"degenerate_faces", defects.degenerate_faces},
          {"duplicate_faces", defects.duplicate_faces},
          {"isolated_vertices", defects.isolated_vertices},
          {"orientable", defects.orientable},
          {"turned_edges", defects.turned_edges},
          {"self_intersections", defects.self_intersections}};
}

nlohmann::ordered_json to_json(const MeshReport& report) {
  nlohmann::ordered_json left_out = nlohmann::ordered_json::array();
  for (const LeftOut& item : report.left_out)
    left_out.push_back({{"what", item.what}, {"count", item.count}});
  return {{"format", report.format},
          {"cut_into_triangles", report.polygons},
          {"merged_corners", report.merged_corners},
          {"left_out", std::move(left_out)}};
}

std::string text_of(const MeshDefects& defects) {
  const std::string sides = !defects.orientable ? "no"
                            : defects.turned_edges > 0
                                ? fmt::format("yes, but faces disagree at {} edges", defects.turned_edges)
                                : "yes";
  const std::string border =
      defects.boundary_loops == 0
          ? "0"
          : fmt::format("{} ({} edges)", defects.boundary_loops, defects.boundary_edges);
  return line("vertices", defects.vertices) + line("faces", defects.faces) +
         line("components", defects.components) + line("boundary loops", border) +
         line("non-manifold edges", defects.non_manifold_edges) +
         line("non-manifold vertices", defects.non_manifold_vertices) +
         line("degenerate faces", defects.degenerate_faces) +
         line("duplicate faces", defects.duplicate_faces) +
         line("isolated vertices", defects.isolated_vertices) + line("orientable", sides) +
         line("self-intersections", defects.self_intersections);
}

std::string text_of(const MeshReport& report) {
  std::string text;
  if (report.polygons > 0) {
    text += line("cut into triangles",
                 fmt::format("{} of {} faces of the file", report.polygons, report.file_faces));
  }
  if (report.merged_corners > 0) {
    text += line("merged", fmt::format("{} corners at the same place as others", report.merged_corners));
  }
  for (const LeftOut& item : report.left_out) {
    text += line("left out", fmt::format("{} {}", item.count, item.what));
  }
  return text;
}

}  // namespace offing::mesh_tools
