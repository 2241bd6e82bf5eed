#include "host/base/parameter_check.h"

#include <fmt/format.h>

#include "host/base/error.h"

namespace offing {

void require_within(std::string_view name, double value, double low, double high) {
  if (value >= low && value <= high) return;
  throw Error(ErrorKind::bad_input,
              fmt::format("{}: expected a number within [{:g}, {:g}], found {:g}", name, low, high, value),
              fmt::format("set {} to a value between {:g} and {:g}", name, low, high));
}

}  // namespace offing
