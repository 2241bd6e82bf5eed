#pragma once

#include <vector>

#include "host/base/error.h"

namespace offing {

/// Several errors at once, as a file may have them. As an Error it is the first one; report() prints all.
class ErrorList : public Error {
 public:
  /// Of at least one error.
  explicit ErrorList(std::vector<Error> errors) : Error(errors.front()), errors_(std::move(errors)) {}

  const std::vector<Error>& errors() const noexcept { return errors_; }

 private:
  std::vector<Error> errors_;
};

}  // namespace offing
