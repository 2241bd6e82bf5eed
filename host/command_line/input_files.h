#pragma once

#include <filesystem>
#include <set>
#include <span>
#include <string>
#include <utility>

#include <sys/types.h>

namespace offing {

/// The files that a command reads. They are told apart by device and inode, not by name, so that another
/// path, a symbolic link or a hard link makes no difference.
class InputFiles {
 public:
  /// `names` are files and folders as the user gave them; empty ones and those that do not exist are passed
  /// over. With each come the files that are read along with it: those in a folder, all below a tile store (a
  /// store may lie in the folder of maps that it is made of), the directional
  /// files of an NDBC spectrum, buffers and images of a glTF, what GDAL reads beside a raster (.aux.xml,
  /// .tfw, the sources of a VRT).
  explicit InputFiles(std::span<const std::string> names);

  bool contains(const std::filesystem::path& path) const;

 private:
  void add(const std::filesystem::path& path);
  template <class Iterator>
  void add_entries(const std::filesystem::path& folder);

  std::set<std::pair<dev_t, ino_t>> files_;
};

}  // namespace offing
