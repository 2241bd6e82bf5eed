#pragma once

#include <vector>

#include "host/base/error.h"

namespace offing {

/// Several errors of one file. As an Error it is the first one; report() prints all.
class ErrorList : public Error {
 public:
  /// `errors` holds at least one.
  explicit ErrorList(std::vector<Error> errors) : Error(errors.front()), errors_(std::move(errors)) {}

  const std::vector<Error>& errors() const noexcept { return errors_; }

 private:
  std::vector<Error> errors_;
};

}  // namespace offing
