#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace offing::present {

/// Which files a FileBrowser lists.
enum class FileFilter {
  known,
  scenes,
  meshes,
  height_maps,
  spectra,
  clouds,
  aerial_pictures,
  pictures,
  single_waves,
  hydrodynamics,
  all
};
inline constexpr std::array<const char*, 11> file_filter_names{"all that Offing reads",
                                                               "scenes",
                                                               "meshes",
                                                               "height maps",
                                                               "wave spectra",
                                                               "clouds",
                                                               "aerial pictures",
                                                               "pictures",
                                                               "single waves",
                                                               "hydrodynamics of hulls",
                                                               "all files"};

/// A file or a folder in a list.
struct FileEntry {
  std::string name;  ///< without its folder
  bool is_folder = false;
  std::optional<std::uintmax_t> bytes = {};      ///< of a file; tile stores, which are folders, have none
  std::filesystem::file_time_type written = {};  ///< when it was last written
};

/// How a FileBrowser sorts: by name, the largest first, or the newest first.
enum class FileOrder { name, size, time };

/// "1.2 MB".
std::string shown_size(std::uintmax_t bytes);
/// "2026-11-28 14:05", in local time.
std::string shown_time(std::filesystem::file_time_type time);

/// The contents of one folder, as a file dialog shows them: ".." and folders first, then the files that the
/// filter lets through, in the order that was chosen. Hidden ones are left out. A tile store counts as a
/// file.
class FileBrowser {
 public:
  /// Shows another folder; false where it cannot be read, and then stays where it was. Relative ones begin at
  /// the folder that is shown, at first the current one.
  bool go_to(const std::filesystem::path& folder);
  void set_filter(FileFilter filter);
  FileFilter filter() const { return filter_; }
  void set_order(FileOrder order);
  FileOrder order() const { return order_; }
  /// Absolute.
  const std::filesystem::path& folder() const { return folder_; }
  const std::vector<FileEntry>& entries() const { return entries_; }
  /// What a typed name means in this folder: "sea.toml", "../sea.toml", "/tmp/sea.toml", "~/sea.toml".
  std::filesystem::path at(const std::string& typed) const;

 private:
  std::filesystem::path folder_;
  FileFilter filter_ = FileFilter::known;
  FileOrder order_ = FileOrder::name;
  std::vector<FileEntry> entries_;
};

/// Whether a filter lets a file through, as far as its name tells.
bool passes(FileFilter filter, const std::filesystem::path& file);
/// Whether a dialog goes into it rather than taking it.
bool is_folder_to_enter(const std::filesystem::path& path);

}  // namespace offing::present
