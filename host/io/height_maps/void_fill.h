#pragma once

#include <cstdint>
#include <span>

namespace offing {

/// Fills voids of a height map from the posts around them, whatever their size, in time proportional to the
/// map.
///
/// heights_m [rows][columns] m, is_void [rows][columns], 1 marks a void; at least one post must be none.
/// Others keep their heights; a void's lies between the lowest and the highest of them, near its rim near the
/// rim's, in the middle of a wide void a mean of wide surroundings. Method: pull-push, a pyramid of means of
/// known posts by 2x2, from which unknown posts take a bilinear mixture of the coarser level. Gortler,
/// Grzeszczuk, Szeliski, Cohen 1996, "The Lumigraph".
void fill_voids(int columns, int rows, std::span<float> heights_m, std::span<const std::uint8_t> is_void);

}  // namespace offing
