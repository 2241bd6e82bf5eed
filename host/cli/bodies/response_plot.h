#pragma once

#include <string>
#include <vector>

#include "host/cli/bodies/linear_body.h"
#include "host/io/png_image.h"

namespace offing::cli {

/// The answer of a body to waves of one direction.
struct ResponseCurve {
  std::string label;
  std::vector<Response> responses;  ///< [period]
};

/// A picture of 1240 x 760 pixels: the amplitude of each motion against the period, a curve for each
/// direction.
RgbImage draw_response_plot(const std::string& title, const std::vector<double>& periods_s,
                            const std::vector<ResponseCurve>& curves);

}  // namespace offing::cli
