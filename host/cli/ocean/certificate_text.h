#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "host/cli/common/direction_text.h"
#include "host/scene/measure/certificate.h"
#include "host/scene/prepare/sea.h"

namespace offing::cli {

/// The certificate for people: a table of what was asked and what was found, the cascades, and what to make
/// of it.
std::string certificate_text(const scene::Certificate& certificate, const scene::Sea& sea,
                             DirectionStyle style);

/// The certificate for scripts: "asked" and "measured" as documented, and beside them "resolved",
/// "standard_error", "spread", "foam", "cascades", "out_of_band_m2", "m0_m2", "seeds".
nlohmann::json certificate_json(const scene::Certificate& certificate, const scene::Sea& sea,
                                DirectionStyle style);

}  // namespace offing::cli
