#include "present/files/file_browser.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <initializer_list>
#include <string_view>
#include <system_error>
#include <tuple>

#include <fmt/format.h>

#include "host/io/file_extension.h"
#include "host/io/tile_store/tile_store.h"
#include "present/window/dropped_files.h"

namespace offing::present {

namespace {

bool ends_in(const std::filesystem::path& file, std::initializer_list<std::string_view> extensions) {
  return std::ranges::find(extensions, lower_extension(file)) != extensions.end();
}

}  // namespace

std::string shown_size(std::uintmax_t bytes) {
  constexpr std::array<const char*, 5> units{"B", "kB", "MB", "GB", "TB"};
  auto size = static_cast<double>(bytes);
  std::size_t unit = 0;
  for (; size >= 999.5 && unit + 1 < units.size(); ++unit) size /= 1000.0;
  const int digits = unit > 0 && size < 9.95 ? 1 : 0;
  return fmt::format("{:.{}f} {}", size, digits, units[unit]);
}

std::string shown_time(std::filesystem::file_time_type time) {
  const auto since = std::chrono::file_clock::to_sys(time);
  const std::time_t seconds =
      std::chrono::system_clock::to_time_t(std::chrono::floor<std::chrono::seconds>(since));
  std::tm local{};
  localtime_r(&seconds, &local);
  return fmt::format("{:04}-{:02}-{:02} {:02}:{:02}", local.tm_year + 1900, local.tm_mon + 1, local.tm_mday,
                     local.tm_hour, local.tm_min);
}

bool is_folder_to_enter(const std::filesystem::path& path) {
  std::error_code unknown;
  return std::filesystem::is_directory(path, unknown) && !is_tile_store(path);
}

bool passes(FileFilter filter, const std::filesystem::path& file) {
  switch (filter) {
    case FileFilter::all:
      return true;
    case FileFilter::known:
      return may_be(file, DroppedKind::scene) || may_be(file, DroppedKind::mesh) ||
             may_be(file, DroppedKind::height_map) || may_be(file, DroppedKind::spectrum) ||
             may_be(file, DroppedKind::cloud);
    case FileFilter::scenes:
      return may_be(file, DroppedKind::scene);
    case FileFilter::meshes:
      return may_be(file, DroppedKind::mesh);
    case FileFilter::height_maps:
      return may_be(file, DroppedKind::height_map);
    case FileFilter::spectra:
      return may_be(file, DroppedKind::spectrum);
    case FileFilter::clouds:
      return may_be(file, DroppedKind::cloud);
    case FileFilter::aerial_pictures:
      return ends_in(file, {".tif", ".tiff", ".png", ".jpg", ".jpeg", ".jp2", ".vrt"});
    case FileFilter::pictures:
      return ends_in(file, {".png"});
    case FileFilter::single_waves:
      return ends_in(file, {".nc", ".csv"});
    case FileFilter::hydrodynamics:
      return ends_in(file, {".nc", ".1", ".3", ".hst"});
  }
  return false;
}

std::filesystem::path FileBrowser::at(const std::string& typed) const {
  const char* home = std::getenv("HOME");
  const bool is_of_home = home != nullptr && (typed == "~" || typed.starts_with("~/"));
  const std::filesystem::path path =
      is_of_home ? std::filesystem::path(home) / typed.substr(std::min<std::size_t>(2, typed.size()))
                 : folder_ / typed;
  return path.lexically_normal();
}

bool FileBrowser::go_to(const std::filesystem::path& folder) {
  std::error_code failed;
  std::filesystem::path whole = std::filesystem::current_path(failed) / folder_ / folder;
  whole = whole.lexically_normal();
  if (!whole.has_filename()) whole = whole.parent_path();  // "/tmp/" is "/tmp"
  std::filesystem::directory_iterator entry(whole, failed);
  if (failed) return false;
  std::vector<FileEntry> entries;
  for (; !failed && entry != std::filesystem::directory_iterator(); entry.increment(failed)) {
    const std::string name = entry->path().filename().string();
    if (name.starts_with('.')) continue;
    const bool is_folder = is_folder_to_enter(entry->path());
    if (!is_folder && !passes(filter_, entry->path())) continue;
    std::error_code unknown;
    std::optional<std::uintmax_t> bytes;
    if (!entry->is_directory(unknown)) bytes = entry->file_size(unknown);
    if (unknown) bytes.reset();
    const auto written = entry->last_write_time(unknown);
    entries.push_back({name, is_folder, bytes, unknown ? std::filesystem::file_time_type{} : written});
  }
  std::ranges::sort(entries, {}, [this](const FileEntry& each) {
    const auto size = order_ == FileOrder::size ? each.bytes.value_or(0) : 0;
    const auto time = order_ == FileOrder::time ? each.written : std::filesystem::file_time_type{};
    return std::tuple(!each.is_folder, ~size, -time.time_since_epoch(), std::string_view(each.name));
  });
  if (whole.has_relative_path()) entries.insert(entries.begin(), {"..", true});
  folder_ = std::move(whole);
  entries_ = std::move(entries);
  return true;
}

void FileBrowser::set_order(FileOrder order) {
  order_ = order;
  go_to(folder_);
}

void FileBrowser::set_filter(FileFilter filter) {
  filter_ = filter;
  go_to(folder_);
}

}  // namespace offing::present
