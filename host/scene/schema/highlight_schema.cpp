#include <utility>

#include <glm/vec2.hpp>

#include "host/scene/schema/parameter_storage.h"
#include "host/scene/schema/row_lists.h"

namespace offing::scene {

namespace {

using highlights::HighlightControls;
using highlights::HighlightRule;
using enum ParameterMotion;

constexpr auto meshes = &Scene::meshes;
constexpr auto list = &MeshScene::highlights;
constexpr auto rule = &HighlightScene::rule;
constexpr auto controls = &HighlightRule::controls;
constexpr std::size_t max_highlights = 256;
constexpr double farthest_m = 1e7;

std::vector<Parameter> in_highlights(std::vector<Parameter> rows) {
  for (Parameter& row : rows) {
    if (row.use == ParameterUse::always) row.use = ParameterUse::found_highlights;
  }
  return rows_of_section(section_of_inner_list<meshes, list>, ParameterGroup::highlight, max_highlights,
                         std::move(rows));
}

/// Which highlights it is for, and where.
std::vector<Parameter> choosing_rows() {
  return in_highlights(
      {{.key = "mesh.highlight.light",
        .storage = &inner_element<meshes, list, &HighlightScene::light>,
        .help = "only the highlights of this light: the name of a [[light]], or sun",
        .example = "sun",
        .absent = "all lights",
        .rule = ParameterRule::name},
       {.key = "mesh.highlight.nearest_m",
        .storage = &inner_element<meshes, list, rule, &HighlightRule::nearest_m>,
        .unit = "m",
        .low = -farthest_m,
        .high = farthest_m,
        .help = "only the highlight nearest to this place, x, y, z of the mesh",
        .example = "[0, 0.5, 0.5]",
        .absent = "all highlights"},
       {.key = "mesh.highlight.pin_m",
        .storage = &inner_element<meshes, list, rule, &HighlightRule::pin_m>,
        .unit = "m",
        .low = -farthest_m,
        .high = farthest_m,
        .help = "a highlight of its own that stays at this place, x, y, z of the mesh, whatever the light",
        .example = "[0, 0.5, 0.5]",
        .absent = "those that light makes",
        .instead_of = "mesh.highlight.nearest_m"},
       {.key = "mesh.highlight.mask_m",
        .storage = &inner_element<meshes, list, rule, &HighlightRule::mask_m>,
        .unit = "m",
        .low = -farthest_m,
        .high = farthest_m,
        .help = "highlights are drawn around this place only, x, y, z of the mesh",
        .example = "[0, 0.5, 0.5]",
        .absent = "everywhere"},
       {.key = "mesh.highlight.mask_radius_m",
        .storage = &inner_element<meshes, list, rule, &HighlightRule::mask_radius_m>,
        .unit = "m",
        .low = 0.0,
        .high = farthest_m,
        .help = "how far from mask_m",
        .use = ParameterUse::masked_highlight}});
}

/// Where a highlight goes and how large it gets.
std::vector<Parameter> form_rows() {
  using highlights::most_copies, highlights::most_offset;
  constexpr auto offset = &HighlightControls::offset;
  return in_highlights(
      {{.key = "mesh.highlight.offset_right",
        .storage = &inner_element<meshes, list, rule, controls, offset, &glm::dvec2::x>,
        .low = -most_offset,
        .high = most_offset,
        .help = "moved over the surface along the direction of the largest curvature, in half widths",
        .motion = keyed},
       {.key = "mesh.highlight.offset_up",
        .storage = &inner_element<meshes, list, rule, controls, offset, &glm::dvec2::y>,
        .low = -most_offset,
        .high = most_offset,
        .help = "and along that of the smallest, in half heights",
        .motion = keyed},
       {.key = "mesh.highlight.rotation_deg",
        .storage = &inner_element<meshes, list, rule, controls, &HighlightControls::rotation_rad>,
        .unit = "deg",
        .low = -3600.0,
        .high = 3600.0,
        .help = "turned anticlockwise on the surface",
        .scale = radians_per_degree,
        .motion = keyed},
       {.key = "mesh.highlight.scale",
        .storage = &inner_element<meshes, list, rule, controls, &HighlightControls::scale>,
        .low = 0.001,
        .high = 1000.0,
        .help = "of both widths",
        .motion = keyed},
       {.key = "mesh.highlight.anisotropy",
        .storage = &inner_element<meshes, list, rule, controls, &HighlightControls::anisotropy>,
        .low = -1.0,
        .high = 1.0,
        .help = "longer to the right (above 0) or up (below), the area stays",
        .motion = keyed},
       {.key = "mesh.highlight.squareness",
        .storage = &inner_element<meshes, list, rule, controls, &HighlightControls::squareness>,
        .low = 0.0,
        .high = 1.0,
        .help = "0 as the surface bends ... 1 as wide as high, the area stays",
        .motion = keyed},
       {.key = "mesh.highlight.split",
        .storage = &inner_element<meshes, list, rule, controls, &HighlightControls::split>,
        .low = 1.0,
        .high = most_copies,
        .help = "copies side by side"},
       {.key = "mesh.highlight.split_gap",
        .storage = &inner_element<meshes, list, rule, controls, &HighlightControls::split_gap>,
        .low = 0.0,
        .high = 100.0,
        .help = "between copies, in widths of one",
        .use = ParameterUse::split_highlight,
        .motion = keyed}});
}

/// What is drawn.
std::vector<Parameter> texture_rows() {
  return in_highlights(
      {{.key = "mesh.highlight.texture",
        .storage = choice_at<&inner_element<meshes, list, rule, controls, &HighlightControls::texture>>(
            {"dot", "window", "star", "ring", "streak", "heart", "image", "normal_map"}),
        .help = "a shape, a picture with its transparency, or one of normals that is shaded"},
       {.key = "mesh.highlight.picture",
        .storage = &inner_element<meshes, list, &HighlightScene::picture>,
        .help = "PNG for texture = \"image\" or \"normal_map\"",
        .example = "moon.png",
        .absent = "none",
        .rule = ParameterRule::file_name,
        .use = ParameterUse::image_highlight},
       {.key = "mesh.highlight.colour",
        .storage = &inner_element<meshes, list, rule, controls, &HighlightControls::colour>,
        .low = 0.0,
        .high = 100.0,
        .help = "times that of the light, linear Rec.709",
        .motion = keyed},
       {.key = "mesh.highlight.opacity",
        .storage = &inner_element<meshes, list, rule, controls, &HighlightControls::opacity>,
        .low = 0.0,
        .high = 1.0,
        .help = "0 hides it",
        .motion = keyed},
       {.key = "mesh.highlight.softness",
        .storage = &inner_element<meshes, list, rule, controls, &HighlightControls::softness>,
        .low = 0.0,
        .high = 1.0,
        .help = "of a shape's rim, in half widths",
        .use = ParameterUse::shape_highlight,
        .motion = keyed}});
}

}  // namespace

std::vector<Parameter> highlight_parameters() {
  std::vector<Parameter> rows;
  for (const std::vector<Parameter>& more : {choosing_rows(), form_rows(), texture_rows()}) {
    rows.insert(rows.end(), more.begin(), more.end());
  }
  return rows;
}

}  // namespace offing::scene
