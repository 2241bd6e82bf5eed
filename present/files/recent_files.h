#pragma once

#include <filesystem>
#include <vector>

namespace offing::present {

/// Files that windows have opened or saved, the last one first, one a line in a file of the state folder.
class RecentFiles {
 public:
  /// `list`: the file of names; empty: none is kept.
  explicit RecentFiles(std::filesystem::path list) : list_(std::move(list)) {}

  /// Those that are still there. A list that cannot be read is empty.
  std::vector<std::filesystem::path> all() const;
  /// Puts a file first. A list that cannot be written stays as it is: it is only a help.
  void add(const std::filesystem::path& file);

 private:
  std::filesystem::path list_;
};

}  // namespace offing::present
