#include "host/ocean/ocean_limits.h"

#include <bit>
#include <limits>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/parameter_check.h"

namespace offing::ocean {

void require_within(std::string_view name, double value, double low, double high) {
  offing::require_within(fmt::format("ocean.{}", name), value, low, high);
}

void require_valid_dispersion(const Dispersion& dispersion) {
  require_within("gravity_mps2", dispersion.gravity_mps2, 0.1, 100.0);
  require_within("depth_m", dispersion.depth_m, 0.1, std::numeric_limits<double>::infinity());
  require_within("capillary_length_m", dispersion.capillary_length_m, 0.0, 0.1);
}

void require_valid_size(int size) {
  if (size < 16 || size > largest_size || !std::has_single_bit(static_cast<unsigned>(size))) {
    throw Error(
        ErrorKind::bad_input,
        fmt::format("ocean.size: expected a power of two within [16, {}], found {}", largest_size, size),
        "set size to 256, 512 or 1024, for example");
  }
}

}  // namespace offing::ocean
