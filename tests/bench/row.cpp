// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#include "tests/bench/row.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace offing::bench {
namespace {

using Json = nlohmann::ordered_json;

Json number_or_null(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

std::string number_or_dash(const std::optional<double>& value, int decimals) {
  return value ? fmt::format("{:.{}f}", *value, decimals) : "-";
}

}  // namespace

Row row_of(std::string name, int size, std::string peer, const Comparison& comparison) {
  return {.name = std::move(name),
          .size = size,
          .ours_ms = comparison.ours_ms,
          .peer = std::move(peer),
          .peer_ms = comparison.peer_ms,
          .ratio = comparison.ratio,
          .ratio_low = comparison.ratio_low,
          .spread = comparison.spread};
}

std::string table_heading() {
  return fmt::format("{:<17} {:>5} {:>11} {:>11} {:>7} {:>7} {:>7}  {}", "name", "size", "ours ms", "peer ms",
                     "ratio", "low", "spread", "peer");
}

std::string table_line(const Row& row) {
  return fmt::format("{:<17} {:>5} {:>11.4f} {:>11} {:>7} {:>7} {:>6.1f}%  {}", row.name, row.size,
                     row.ours_ms, number_or_dash(row.peer_ms, 4), number_or_dash(row.ratio, 2),
                     number_or_dash(row.ratio_low, 2), 100.0 * row.spread, row.peer);
}

std::string to_json(const std::vector<Row>& rows) {
  Json array = Json::array();
  for (const Row& row : rows) {
    array.push_back({{"name", row.name},
                     {"size", row.size},
                     {"ours_ms", row.ours_ms},
                     {"peer", row.peer},
                     {"peer_ms", number_or_null(row.peer_ms)},
                     {"ratio", number_or_null(row.ratio)},
                     {"ratio_low", number_or_null(row.ratio_low)},
                     {"spread", row.spread}});
    if (row.steps) {
      array.back()["steps"] = {{"mean", row.steps->mean},           {"of_90", row.steps->of_90},
                               {"of_95", row.steps->of_95},         {"of_99", row.steps->of_99},
                               {"within_16", row.steps->within_16}, {"over_80", row.steps->over_80}};
    }
  }
  return array.dump(2);
}

}  // namespace offing::bench
