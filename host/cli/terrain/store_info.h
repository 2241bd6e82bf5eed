#pragma once

#include <string>

namespace offing::cli {

enum class InfoStyle { text, json };

/// Prints what a tile store says of its map, as `offing terrain info` does of other maps.
void print_store_info(const std::string& folder, InfoStyle style);

}  // namespace offing::cli
