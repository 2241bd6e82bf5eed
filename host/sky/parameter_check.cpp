#include "host/sky/parameter_check.h"

#include "host/base/parameter_check.h"

namespace offing::sky {

void require_within(std::string_view name, double value, double low, double high) {
  offing::require_within(name, value, low, high);
}

}  // namespace offing::sky
