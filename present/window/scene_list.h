#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace offing::present {

/// A scene that a window can open.
struct ListedScene {
  std::string name;            ///< "storm.toml"
  std::filesystem::path file;  ///< empty: it comes with the program

  bool is_shipped() const { return file.empty(); }
  bool operator==(const ListedScene&) const = default;
};

/// The scenes that come with the program, and the files beside the one that is open, by their names.
class SceneList {
 public:
  SceneList();

  /// From here on files are those beside this one; without one those of the folder before, at first of the
  /// current one.
  void follow(const std::filesystem::path& file);
  /// Looks for files again. A folder that cannot be read has none.
  void look();
  const std::vector<ListedScene>& shipped() const { return shipped_; }
  const std::vector<ListedScene>& beside() const { return beside_; }
  /// Of beside(), "" for the current one.
  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::vector<ListedScene> shipped_, beside_;
  std::filesystem::path folder_;
};

}  // namespace offing::present
