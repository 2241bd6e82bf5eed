#include "host/base/error.h"

#include <utility>

namespace offing {

Error::Error(ErrorKind kind, const std::string& what, std::string hint)
    : std::runtime_error(what), kind_(kind), hint_(std::move(hint)) {}

int exit_code(ErrorKind kind) noexcept {
  switch (kind) {
    case ErrorKind::bad_usage:
    case ErrorKind::bad_input:
      return 2;
    case ErrorKind::no_device:
      return 3;
    case ErrorKind::cancelled:
      return 130;  // 128 + SIGINT, as shells report it
    default:
      return 1;
  }
}

}  // namespace offing
