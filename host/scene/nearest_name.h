#pragma once

#include <span>
#include <string>
#include <string_view>

namespace offing::scene {

/// The candidate that a misspelled name most likely meant: the one with the fewest inserted, dropped or
/// changed characters, if these are at most a third of the name; else empty.
std::string_view nearest_name(std::string_view name, std::span<const std::string_view> candidates);

}  // namespace offing::scene
