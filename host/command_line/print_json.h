#pragma once

#include <nlohmann/json.hpp>

namespace offing {

/// Prints results as scripts take them. Bytes that are no UTF-8, as names of files may hold, are replaced.
void print_json(const nlohmann::ordered_json& json);

}  // namespace offing
