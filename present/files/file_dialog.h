#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/io/atomic_file.h"
#include "present/files/file_browser.h"

namespace offing::present {

/// What a file is chosen for.
enum class FilePurpose {
  open,
  save_scene,
  value,         ///< of a scene: the name of the file
  folder_value,  ///< the same of a folder
};

struct ChosenFile {
  std::filesystem::path file;
  FilePurpose purpose = FilePurpose::open;
  Existing existing = Existing::keep;  ///< of a file to save: whether the user wants it to be replaced
};

/// A dialog of the panels in which the user chooses a file: from the list of a folder, from those of late, or
/// by its name. The name always has the keyboard: up and down go through the list, Enter takes the name or
/// goes into the folder, Esc closes the dialog.
class FileDialog {
 public:
  struct Request {
    FilePurpose purpose = FilePurpose::open;
    FileFilter filter = FileFilter::known;
    std::filesystem::path folder = {};  ///< that it shows first; empty: the current one
    std::string name = {};              ///< that is offered to save as
    std::vector<std::filesystem::path> recent = {};
  };

  void open(const Request& request);
  bool is_open() const { return is_open_; }
  void close() { is_open_ = false; }
  /// All names that it shows, in letters of any language.
  void for_shown_names(const std::function<void(std::string_view)>& tell) const;
  /// Between PanelLayer::begin() and end(); what was chosen, once.
  std::optional<ChosenFile> draw();

 private:
  void draw_folder();
  void draw_new_folder();
  void draw_head();
  void draw_places();
  void draw_entries();
  void draw_name();
  void draw_answers();
  /// A name was entered: goes into the folder, asks whether a file is to be replaced, or is done.
  void accept();
  void accept_to_save(std::filesystem::path file);
  void go_to(const std::filesystem::path& folder);
  /// The name of the entry so many places after that of the name field.
  std::optional<std::string> name_beside(int step) const;
  bool is_saving() const { return request_.purpose == FilePurpose::save_scene; }
  bool is_of_folders() const { return request_.purpose == FilePurpose::folder_value; }

  bool is_open_ = false;
  Request request_;
  FileBrowser browser_;
  std::string folder_text_, name_, fault_;
  std::optional<std::string> new_folder_;  // its name, while it is typed
  std::filesystem::path asked_;            // is there already; empty: there is no question
  bool answers_replace_ = false;
  bool focuses_name_ = false, scrolls_ = false, has_list_ = false;
  std::optional<ChosenFile> chosen_;
};

}  // namespace offing::present
