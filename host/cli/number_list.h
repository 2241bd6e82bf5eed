#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace offing::cli {

/// Finite numbers between commas, as many as `count`; throws bad_argument() that expects `form` otherwise.
std::vector<double> read_numbers(std::string_view flag, std::string_view text, std::size_t count,
                                 std::string_view form, std::string_view example);

/// A finite number within [low, high]; throws bad_argument() otherwise.
double read_number(std::string_view flag, std::string_view text, double low, double high,
                   std::string_view example);

}  // namespace offing::cli
