#pragma once

#include <deque>
#include <filesystem>
#include <optional>
#include <vector>

#include "present/panels.h"

namespace offing::present {

/// Files that wait to be read, one a frame: the message line of the frame before says which, as reading can
/// take a while. What is said of files that came together is kept in one message.
class FileQueue {
 public:
  void add(const std::vector<std::filesystem::path>& files);
  /// The next file, once the message has announced it; nothing where there is none, or it does so now.
  std::optional<std::filesystem::path> next(Message& message);
  /// The message is of the file that was given last: it comes behind those of the files before it.
  void note(Message& message);

 private:
  std::deque<std::filesystem::path> waiting_;
  Message said_;
  bool is_announced_ = false;
};

}  // namespace offing::present
