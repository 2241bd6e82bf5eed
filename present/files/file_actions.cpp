#include "present/files/file_actions.h"

#include <system_error>

#include <fmt/format.h>

#include "host/base/error.h"

namespace offing::present {

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
    const std::filesystem::path file = work();
    std::error_code failure;
    const std::filesystem::path whole = std::filesystem::absolute(file, failure);
    list_.follow(file);
    recent_.add(file);
    state_.message = {.text = fmt::format("wrote {}", (failure ? file : whole).string())};
  } catch (const Error& error) {
    state_.message = fault_message(error);
  }
}

void FileActions::draw() {
  const std::optional<ChosenFile> chosen = dialog_.draw();
  if (!chosen) return;
  if (chosen->purpose == FilePurpose::open) return intake_.open_file(chosen->file);
  write([&] { return scenes_.save_as(chosen->file, chosen->existing); });
}

}  // namespace offing::present
