#include "present/window/file_queue.h"

#include <utility>

#include <fmt/format.h>

#include "host/base/error.h"

namespace offing::present {

void FileQueue::add(const std::vector<WaitingFile>& files) {
  if (waiting_.empty()) said_ = {};
  waiting_.insert(waiting_.end(), files.begin(), files.end());
}

std::optional<WaitingFile> FileQueue::next(Message& message) {
  if (waiting_.empty()) return {};
  if (!std::exchange(is_announced_, !is_announced_)) {
    message = said_;
    if (!message.text.empty()) message.text += '\n';
    message.text += fmt::format("reading {} ...", one_line(waiting_.front().file.filename().string()));
    return {};
  }
  WaitingFile file = std::move(waiting_.front());
  waiting_.pop_front();
  return file;
}

void FileQueue::note(Message& message) {
  if (!said_.text.empty()) said_.text += '\n';
  said_.text += message.text;
  said_.is_fault = said_.is_fault || message.is_fault;
  message = said_;
}

}  // namespace offing::present
