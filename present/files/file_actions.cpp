#include "present/files/file_actions.h"

#include <algorithm>
#include <array>
#include <system_error>
#include <variant>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/scene/schema/parameter_table.h"
#include "host/scene/schema/scene_elements.h"
#include "present/panels/parameter_widget.h"
#include "present/window/dropped_files.h"

namespace offing::present {

namespace {

bool names_folder(std::string_view key) {
  return key.ends_with("_billboards");
}

}  // namespace

bool FileActions::act(ViewAction action) {
  switch (action) {
    case ViewAction::new_scene:
      intake_.open_new();
      return true;
    case ViewAction::open_file:
      open(FileFilter::known);
      return true;
    case ViewAction::save:
      save();
      return true;
    case ViewAction::save_as:
      ask_where_to_save();
      return true;
    default:
      return false;
  }
}

void FileActions::open(FileFilter filter) {
  dialog_.open(
      {.filter = filter, .folder = options_.scene_file.parent_path(), .name = {}, .recent = recent_.all()});
}

void FileActions::browse(const scene::ValueKey& value) {
  const scene::Parameter& row = *scene::find_parameter(value.key);
  const std::filesystem::path now = std::get<scene::ValueAt<std::string>>(row.storage)
                                        .in(scene::struct_at(&state_.scene, *row.section, value.element));
  const bool is_folder = names_folder(value.key);
  const std::filesystem::path folder = now.empty() ? options_.scene_file.parent_path()
                                       : is_folder ? now
                                                   : now.parent_path();
  dialog_.open({.purpose = is_folder ? FilePurpose::folder_value : FilePurpose::value,
                .filter = filter_of_row(value.key),
                .folder = folder,
                .name = {},
                .recent = recent_.all()});
  browsed_ = value;
}

void FileActions::take_value(const std::filesystem::path& file) {
  const scene::Parameter& row = *scene::find_parameter(browsed_->key);
  editing_.make([&](scene::Scene& scene) {
    // What the map or the record before needed says nothing about this one.
    if (row.key == "terrain.file") return add_dropped(scene, file, DroppedKind::height_map, {});
    if (row.key == "ocean.spectrum_file") return add_dropped(scene, file, DroppedKind::spectrum, {});
    const std::string name = file.string();
    scene::store(scene, row, {.value = name, .shown = one_line(name)}, {.subject = std::string(row.key)},
                 browsed_->element);
    return fmt::format("{}: {}", words_of(row), one_line(file.filename().string()));
  });
  if (!state_.message.is_fault && !names_folder(row.key)) recent_.add(file);
}

void FileActions::save() {
  if (!scenes_.has_file()) return ask_where_to_save();
  write([&] { return scenes_.save(); });
}

void FileActions::ask_where_to_save() {
  dialog_.open({.purpose = FilePurpose::save_scene,
                .filter = FileFilter::scenes,
                .folder = options_.scene_file.parent_path(),
                .name = scenes_.first_name().filename().string(),
                .recent = recent_.all()});
}

void FileActions::write(const std::function<std::filesystem::path()>& work) {
  try {
    const bool has_moved = scenes_.has_moved();
    const std::filesystem::path file = work();
    std::error_code failure;
    const std::filesystem::path whole = std::filesystem::absolute(file, failure);
    list_.follow(file);
    recent_.add(file);
    state_.message = {.text = fmt::format("wrote {}{}", (failure ? file : whole).string(),
                                          has_moved ? "; its camera is where you are now" : "")};
  } catch (const Error& error) {
    state_.message = fault_message(error);
  }
}

void FileActions::draw() {
  const std::optional<ChosenFile> chosen = dialog_.draw();
  if (!chosen) return;
  switch (chosen->purpose) {
    case FilePurpose::open:
      return intake_.open_file(chosen->file);
    case FilePurpose::value:
    case FilePurpose::folder_value:
      return take_value(chosen->file);
    case FilePurpose::save_scene:
      break;
  }
  write([&] { return scenes_.save_as(chosen->file, chosen->existing); });
}

FileFilter filter_of_row(std::string_view key) {
  struct Kind {
    std::string_view key;
    FileFilter filter;
  };
  static constexpr auto kinds = std::to_array<Kind>({{"mesh.file", FileFilter::meshes},
                                                     {"mesh.cartoon_ramp", FileFilter::pictures},
                                                     {"mesh.highlight.picture", FileFilter::pictures},
                                                     {"cloud.file", FileFilter::clouds},
                                                     {"cloud.mesh", FileFilter::meshes},
                                                     {"clouds.crisp_billboards", FileFilter::pictures},
                                                     {"clouds.soft_billboards", FileFilter::pictures},
                                                     {"terrain.file", FileFilter::height_maps},
                                                     {"terrain.colour", FileFilter::aerial_pictures},
                                                     {"terrain.canopy.map", FileFilter::aerial_pictures},
                                                     {"ocean.spectrum_file", FileFilter::spectra},
                                                     {"ocean.modes_file", FileFilter::single_waves},
                                                     {"body.hydrodynamics", FileFilter::hydrodynamics}});
  const auto found = std::ranges::find(kinds, key, &Kind::key);
  return found == kinds.end() ? FileFilter::all : found->filter;
}

}  // namespace offing::present
