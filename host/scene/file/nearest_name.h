#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace offing::scene {

/// The candidate that a misspelled name most likely meant: the one with the fewest inserted, dropped or
/// changed characters, if these are at most a third of the name; else empty.
std::string_view nearest_name(std::string_view name, std::span<const std::string_view> candidates);

/// A hint for a name that is none of those known: the one that was most likely meant and the first 20 of all,
/// or `without_any` where none is known.
std::string hint_of_names(std::string_view name, const std::vector<std::string>& known,
                          std::string_view without_any);

}  // namespace offing::scene
