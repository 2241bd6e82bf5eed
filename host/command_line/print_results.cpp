#include "host/command_line/print_results.h"

#include <fmt/format.h>

namespace offing {

void print_json(const nlohmann::ordered_json& json) {
  fmt::print("{}\n", json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

}  // namespace offing
