#pragma once

#include <deque>
#include <filesystem>
#include <optional>
#include <vector>

#include "present/panels/panels.h"

namespace offing::present {

/// Where a file comes from that is to be read.
enum class FileSource {
  dropped,
  chosen,     ///< from a dialog or a list
  shipped,    ///< a scene that comes with the program
  new_scene,  ///< there is no file
};

struct WaitingFile {
  std::filesystem::path file;  ///< of a scene that comes with the program its name
  FileSource source = FileSource::dropped;
};

/// Files that wait to be read, one a frame: the message line of the frame before says which, as reading can
/// take a while. What is said of files that came together is kept in one message.
class FileQueue {
 public:
  void add(const std::vector<WaitingFile>& files);
  bool is_empty() const { return waiting_.empty(); }
  /// The next file, once the message has announced it; nothing where there is none, or it does so now.
  std::optional<WaitingFile> next(Message& message);
  /// The message is of the file that was given last: it comes behind those of the files before it.
  void note(Message& message);

 private:
  std::deque<WaitingFile> waiting_;
  Message said_;
  bool is_announced_ = false;
};

}  // namespace offing::present
