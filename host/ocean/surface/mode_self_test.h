#pragma once

#include "host/ocean/surface/mode_transform.h"
#include "host/ocl/device.h"

namespace offing::ocean {

// Self-tests of the kernels that turn modes into fields: one cascade of size x size random modes, each of
// which has a part in every field, against sums of these modes on the host in double precision. All fields
// are compared, on all rows of a small cascade and on some rows of a large one. On a busy machine of two
// cores a test took 0.02 s at size 16, 0.2 s at 512 and 5 s at 4096.

/// The relative root mean square errors of a transform by ocean/spectrum_advance.cl and
/// ocean/surface_assemble.cl, added up over its four pairs of fields.
double surface_self_test(const ocl::Device& device, ModeTransform& transform, const ModeTransform::Grid& grid,
                         const ModeTransform::Request& request);

/// The same of ocean/velocity_advance.cl and ocean/velocity_assemble.cl, of two pairs.
double velocity_self_test(const ocl::Device& device, ModeTransform& transform,
                          const ModeTransform::Grid& grid, const ModeTransform::Request& request);

/// The largest such error of the fields of ocean/query_map_columns.cl and ocean/query_map_rows.cl, without a
/// filter.
double query_map_self_test(const ocl::Device& device, ModeTransform& transform,
                           const ModeTransform::Grid& grid, const ModeTransform::Request& request);

}  // namespace offing::ocean
