#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include <glm/vec3.hpp>

#include "host/scene/schema/parameter.h"

namespace offing::scene {

/// Years for which the sun's place is known (host/sky/sun_position.h).
inline constexpr int first_year = 1900, last_year = 2100;

/// Whether values are written in quotes, or as lists of three numbers.
bool is_text(const Parameter& parameter);
bool is_triple(const Parameter& parameter);

// What was written as a row has it stored. All throw Error(bad_input) that names place, expected and found.

double checked_number(const Parameter& parameter, const WrittenValue& written, const Place& place);
glm::dvec3 checked_triple(const Parameter& parameter, const WrittenValue& written, const Place& place);
std::int64_t checked_whole(const Parameter& parameter, const WrittenValue& written, const Place& place);
/// Text: not empty, and free of control characters, which would break messages and cut a file's name at a
/// NUL.
const std::string& checked_name(const Parameter& parameter, const WrittenValue& written, const Place& place);
UtcTime checked_time(const Parameter& parameter, const WrittenValue& written, const Place& place);
/// The index of its name.
std::size_t checked_choice(const Parameter& parameter, const ChoiceStorage& choice,
                           const WrittenValue& written, const Place& place);

}  // namespace offing::scene
