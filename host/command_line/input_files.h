#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <sys/types.h>

#include "host/io/file_trust.h"

namespace offing {

/// Files and folders that a command was given, and what they may lead to.
struct GivenInputs {
  std::vector<std::string> names = {};  ///< empty ones and those that do not exist are passed over
  Trust trust = Trust::trusted;
};

/// The files that a command reads. They are told apart by device and inode, not by name, so that another
/// path, a symbolic link or a hard link makes no difference.
class InputFiles {
 public:
  /// With each come the files that are read along with it: those in a folder, all below a tile store (a store
  /// may lie in the folder of maps that it is made of), the directional files of an NDBC spectrum, buffers
  /// and images of a glTF, what GDAL reads beside a raster (.aux.xml, .tfw, the sources of a VRT). What an
  /// untrusted raster may not lead to is not opened.
  explicit InputFiles(const GivenInputs& inputs);

  bool contains(const std::filesystem::path& path) const;

 private:
  void add(const std::filesystem::path& path);
  template <class Iterator>
  void add_entries(const std::filesystem::path& folder);

  std::set<std::pair<dev_t, ino_t>> files_;
};

}  // namespace offing
