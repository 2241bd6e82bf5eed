#include <utility>

#include "host/scene/schema/sections.h"

namespace offing::scene {

namespace {

using clouds::ParticleEdit;
using clouds::ParticleSelection;

constexpr auto selection = &ParticleEdit::selection;
constexpr double most_shift_m = 1e7, widest = 1e3;

std::vector<Row<ParticleEdit>> eye_rows() {
  return {{path(selection, &ParticleSelection::eye_m),
           {.key = "eye_m",
            .unit = "m",
            .low = -most_shift_m,
            .high = most_shift_m,
            .help = "eye from which the edited particles were selected: x, y, z in the cloud's axes"}},
          {path(selection, &ParticleSelection::yaw_rad),
           {.key = "yaw_deg",
            .unit = "deg",
            .low = -360.0,
            .high = 360.0,
            .help = "viewing direction of that eye, clockwise from north (-z)",
            .scale = radians_per_degree}},
          {path(selection, &ParticleSelection::pitch_rad),
           {.key = "pitch_deg",
            .unit = "deg",
            .low = -90.0,
            .high = 90.0,
            .help = "viewing direction of that eye, up from the horizon",
            .scale = radians_per_degree}}};
}

std::vector<Row<ParticleEdit>> rectangle_rows() {
  constexpr auto low = &ParticleSelection::low, high = &ParticleSelection::high;
  std::vector<Row<ParticleEdit>> rows{
      {path(selection, low, &glm::dvec2::x),
       {.key = "left",
        .help = "left side of the selection rectangle, as a slope: metres right per metre ahead"}},
      {path(selection, high, &glm::dvec2::x),
       {.key = "right", .help = "right side of the selection rectangle"}},
      {path(selection, low, &glm::dvec2::y),
       {.key = "bottom",
        .help = "lower side of the selection rectangle, as a slope: metres up per metre ahead"}},
      {path(selection, high, &glm::dvec2::y),
       {.key = "top", .help = "upper side of the selection rectangle"}}};
  for (Row<ParticleEdit>& row : rows) {
    row.facts.low = -widest;
    row.facts.high = widest;
  }
  return rows;
}

std::vector<Row<ParticleEdit>> deed_rows() {
  return {{choice(&ParticleEdit::fate, {"kept", "removed"}),
           {.key = "fate", .help = "whether the selected particles are kept or removed"}},
          {&ParticleEdit::push_m,
           {.key = "push_m",
            .unit = "m",
            .low = -1e6,
            .high = 1e6,
            .help = "how far to push the selected particles: x, y, z",
            .slider = {{-500.0, 500.0}}}},
          {&ParticleEdit::albedo,
           {.key = "colour",
            .low = 0.0,
            .high = 1.0,
            .help = "single-scattering albedo in linear Rec.709: red, green, blue",
            .example = "[1, 0.6, 0.5]",
            .absent = "unchanged"}}};
}

}  // namespace

Schema<ParticleEdit> particle_edit_schema() {
  Schema<ParticleEdit> schema("particle_edit");
  for (const auto& rows : {eye_rows(), rectangle_rows(), deed_rows()}) {
    schema.rows(ParameterGroup::particle_edit, Affects::clouds, rows);
  }
  return schema;
}

}  // namespace offing::scene
