#include <utility>

#include "host/scene/schema/parameter_storage.h"
#include "host/scene/schema/row_lists.h"

namespace offing::scene {

namespace {

using clouds::ParticleEdit;
using clouds::ParticleSelection;

constexpr auto singles = &Scene::clouds;
constexpr auto list = &CloudScene::edits;
constexpr auto selection = &ParticleEdit::selection;
constexpr std::size_t max_edits = 4096;
constexpr double farthest_m = 1e7, widest = 1e3;

std::vector<Parameter> in_edits(std::vector<Parameter> rows) {
  return rows_of_section(section_of_inner_list<singles, list>, ParameterGroup::particle_edit, max_edits,
                         std::move(rows));
}

std::vector<Parameter> eye_rows() {
  return in_edits({{.key = "cloud.particle_edit.eye_m",
                    .storage = &inner_element<singles, list, selection, &ParticleSelection::eye_m>,
                    .unit = "m",
                    .low = -farthest_m,
                    .high = farthest_m,
                    .help = "eye that sees what is edited, x, y, z in the cloud's axes"},
                   {.key = "cloud.particle_edit.yaw_deg",
                    .storage = &inner_element<singles, list, selection, &ParticleSelection::yaw_rad>,
                    .unit = "deg",
                    .low = -360.0,
                    .high = 360.0,
                    .help = "where it looks, clockwise from north (-z)",
                    .scale = radians_per_degree},
                   {.key = "cloud.particle_edit.pitch_deg",
                    .storage = &inner_element<singles, list, selection, &ParticleSelection::pitch_rad>,
                    .unit = "deg",
                    .low = -90.0,
                    .high = 90.0,
                    .help = "above the horizon",
                    .scale = radians_per_degree}});
}

std::vector<Parameter> rectangle_rows() {
  constexpr auto low = &ParticleSelection::low, high = &ParticleSelection::high;
  std::vector<Parameter> rows{
      {.key = "cloud.particle_edit.left",
       .storage = &inner_element<singles, list, selection, low, &glm::dvec2::x>,
       .help = "left side of the rectangle that it sees particles in, as a slope: right a metre ahead"},
      {.key = "cloud.particle_edit.right",
       .storage = &inner_element<singles, list, selection, high, &glm::dvec2::x>,
       .help = "its right side"},
      {.key = "cloud.particle_edit.bottom",
       .storage = &inner_element<singles, list, selection, low, &glm::dvec2::y>,
       .help = "its lower side: up a metre ahead"},
      {.key = "cloud.particle_edit.top",
       .storage = &inner_element<singles, list, selection, high, &glm::dvec2::y>,
       .help = "its upper side"}};
  for (Parameter& row : rows) {
    row.low = -widest;
    row.high = widest;
  }
  return in_edits(std::move(rows));
}

std::vector<Parameter> deed_rows() {
  return in_edits(
      {{.key = "cloud.particle_edit.fate",
        .storage = choice_at<&inner_element<singles, list, &ParticleEdit::fate>>({"kept", "removed"}),
        .help = "whether the particles stay"},
       {.key = "cloud.particle_edit.push_m",
        .storage = &inner_element<singles, list, &ParticleEdit::push_m>,
        .unit = "m",
        .low = -1e6,
        .high = 1e6,
        .help = "how far they are pushed, x, y, z",
        .slider = {{-500.0, 500.0}}},
       {.key = "cloud.particle_edit.colour",
        .storage = &inner_element<singles, list, &ParticleEdit::albedo>,
        .low = 0.0,
        .high = 1.0,
        .help = "single-scattering albedo in linear Rec.709: red, green, blue",
        .example = "[1, 0.6, 0.5]",
        .absent = "their own"}});
}

}  // namespace

std::vector<Parameter> particle_edit_parameters() {
  std::vector<Parameter> rows = eye_rows();
  for (const std::vector<Parameter>& more : {rectangle_rows(), deed_rows()}) {
    rows.insert(rows.end(), more.begin(), more.end());
  }
  return rows;
}

}  // namespace offing::scene
