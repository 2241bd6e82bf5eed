#pragma once

#include "host/terrain/analysis/viewshed.h"
#include "tests/terrain/example_maps.h"

namespace offing::test {

/// The least height of the line of sight from an observer to a post above the surface, m, in double
/// precision: at every border that it crosses and where it is lowest between two. Within a cell of its ends,
/// where both may meet, as many times that as the cell is longer than the way from the end. Negative: the
/// post is hidden.
double reference_clearance_m(const HeightMap& map, const terrain::ViewshedParameters& parameters, int column,
                             int row);

}  // namespace offing::test
