#include <array>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <glm/vec2.hpp>

#include "host/scene/schema/sections.h"

namespace offing::scene {

namespace {

using highlights::HighlightControls;
using highlights::HighlightRule;
using enum ParameterMotion;

constexpr auto rule = &HighlightScene::rule;
constexpr auto controls = &HighlightRule::controls;
constexpr double farthest_m = 1e7;
/// Of HighlightTexture.
constexpr std::array<std::string_view, 8> texture_names{"dot",    "window", "star",  "ring",
                                                        "streak", "heart",  "image", "normal_map"};

bool has_image(const HighlightScene& highlight) {
  return is_image(highlight.rule.controls.texture);
}

std::string texture_is(const HighlightScene& highlight) {
  const std::size_t texture = static_cast<std::size_t>(highlight.rule.controls.texture);
  return fmt::format("the texture is {}", texture_names[texture]);
}

std::string needs_highlights(const UseContext& context, const HighlightScene&) {
  return context.scene.meshes[context.element.outer].shown == MeshHighlights::on
             ? ""
             : "the mesh's highlights are off";
}

std::string needs_mask(const UseContext& context, const HighlightScene& highlight) {
  const std::string reason = needs_highlights(context, highlight);
  return reason.empty() && !highlight.rule.mask_m ? "mesh.highlight.mask_m is not given" : reason;
}

std::string needs_copies(const UseContext& context, const HighlightScene& highlight) {
  const std::string reason = needs_highlights(context, highlight);
  return reason.empty() && highlight.rule.controls.split == 1 ? "mesh.highlight.split is 1" : reason;
}

std::string needs_shape(const UseContext& context, const HighlightScene& highlight) {
  const std::string reason = needs_highlights(context, highlight);
  return reason.empty() && has_image(highlight) ? texture_is(highlight) : reason;
}

std::string needs_image(const UseContext& context, const HighlightScene& highlight) {
  const std::string reason = needs_highlights(context, highlight);
  return reason.empty() && !has_image(highlight) ? texture_is(highlight) : reason;
}

/// Which highlights it is for, and where.
std::vector<Row<HighlightScene>> choosing_rows() {
  return {{&HighlightScene::light,
           {.key = "light",
            .help = "change only highlights of this light: the name of a light, or sun",
            .example = "sun",
            .absent = "all lights",
            .rule = ParameterRule::name}},
          {path(rule, &HighlightRule::nearest_m),
           {.key = "nearest_m",
            .unit = "m",
            .low = -farthest_m,
            .high = farthest_m,
            .help = "change only the highlight nearest to this place: x, y, z of the mesh",
            .example = "[0, 0.5, 0.5]",
            .absent = "all highlights"}},
          {path(rule, &HighlightRule::pin_m),
           {.key = "pin_m",
            .unit = "m",
            .low = -farthest_m,
            .high = farthest_m,
            .help = "add a highlight that stays at this place, whatever the light: x, y, z of the mesh",
            .example = "[0, 0.5, 0.5]",
            .absent = "none: highlights come from the lights",
            .instead_of = "nearest_m"}},
          {path(rule, &HighlightRule::mask_m),
           {.key = "mask_m",
            .unit = "m",
            .low = -farthest_m,
            .high = farthest_m,
            .help = "draw highlights only around this place: x, y, z of the mesh",
            .example = "[0, 0.5, 0.5]",
            .absent = "everywhere"}},
          {path(rule, &HighlightRule::mask_radius_m),
           {.key = "mask_radius_m",
            .unit = "m",
            .low = 0.0,
            .high = farthest_m,
            .help = "radius around mask_m within which highlights are drawn"},
           needs_mask}};
}

/// Where a highlight goes and how large it gets.
std::vector<Row<HighlightScene>> highlight_form_rows() {
  using highlights::most_copies, highlights::most_offset;
  constexpr auto offset = &HighlightControls::offset;
  return {
      {path(rule, controls, offset, &glm::dvec2::x),
       {.key = "offset_right",
        .low = -most_offset,
        .high = most_offset,
        .help = "shift over the surface along the direction of largest curvature, in half widths",
        .motion = keyed}},
      {path(rule, controls, offset, &glm::dvec2::y),
       {.key = "offset_up",
        .low = -most_offset,
        .high = most_offset,
        .help = "shift over the surface along the direction of smallest curvature, in half heights",
        .motion = keyed}},
      {path(rule, controls, &HighlightControls::rotation_rad),
       {.key = "rotation_deg",
        .unit = "deg",
        .low = -3600.0,
        .high = 3600.0,
        .help = "turn anticlockwise on the surface",
        .scale = radians_per_degree,
        .motion = keyed}},
      {path(rule, controls, &HighlightControls::upright),
       {.key = "upright",
        .low = 0.0,
        .high = 1.0,
        .help = "direction: 0 follows the surface's curvature ... 1 the picture's top goes up the mesh (y)",
        .motion = keyed}},
      {path(rule, controls, &HighlightControls::scale),
       {.key = "scale", .low = 0.001, .high = 1000.0, .help = "factor on width and height", .motion = keyed}},
      {path(rule, controls, &HighlightControls::anisotropy),
       {.key = "anisotropy",
        .low = -1.0,
        .high = 1.0,
        .help = "stretch to the right (above 0) or up (below 0), keeping the area",
        .motion = keyed}},
      {path(rule, controls, &HighlightControls::squareness),
       {.key = "squareness",
        .low = 0.0,
        .high = 1.0,
        .help = "proportions: 0 follow the surface's curvature ... 1 as wide as high, keeping the area",
        .motion = keyed}},
      {path(rule, controls, &HighlightControls::split),
       {.key = "split", .low = 1.0, .high = most_copies, .help = "number of copies, side by side"}},
      {path(rule, controls, &HighlightControls::split_gap),
       {.key = "split_gap",
        .low = 0.0,
        .high = 100.0,
        .help = "gap between copies, in widths of one copy",
        .motion = keyed},
       needs_copies}};
}

/// What is drawn.
std::vector<Row<HighlightScene>> texture_rows() {
  return {{choice(path(rule, controls, &HighlightControls::texture),
                  {texture_names.begin(), texture_names.end()}),
           {.key = "texture",
            .help = "a shape, a picture with transparency (image), or a normal map to shade (normal_map)"}},
          {&HighlightScene::picture,
           {.key = "picture",
            .help = "PNG for texture = \"image\" or \"normal_map\"",
            .example = "moon.png",
            .absent = "none",
            .rule = ParameterRule::file_name},
           needs_image},
          {path(rule, controls, &HighlightControls::colour),
           {.key = "colour",
            .low = 0.0,
            .high = 100.0,
            .help = "factor on the light's colour, linear Rec.709",
            .motion = keyed}},
          {path(rule, controls, &HighlightControls::opacity),
           {.key = "opacity", .low = 0.0, .high = 1.0, .help = "opacity; 0 hides it", .motion = keyed}},
          {path(rule, controls, &HighlightControls::softness),
           {.key = "softness",
            .low = 0.0,
            .high = 1.0,
            .help = "softness of a shape's edge, in half widths",
            .motion = keyed},
           needs_shape}};
}

}  // namespace

Schema<HighlightScene> highlight_schema() {
  Schema<HighlightScene> schema("highlight");
  for (std::vector<Row<HighlightScene>> rows : {choosing_rows(), highlight_form_rows(), texture_rows()}) {
    for (Row<HighlightScene>& row : rows) {
      if (row.unused == nullptr) row.unused = needs_highlights;
    }
    schema.rows(ParameterGroup::highlight, Affects::highlights, std::move(rows));
  }
  return schema;
}

}  // namespace offing::scene
