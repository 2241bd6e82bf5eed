#pragma once

#include <istream>

#include <openvdb/Grid.h>

#include "host/io/vdb/vdb_values.h"

namespace offing::vdb {

/// OpenVDB trusts the lengths in a file: it allocates up to 4 GiB for a name before it reads it, and version
/// 10 writes a block of the wrong size past the end of its buffer. Call these functions before the library
/// reads the same part. The stream must throw where it ends; its position stays. They throw
/// std::runtime_error.
void check_metadata(std::istream& stream, const PartOfVdb& part);
void check_descriptor(std::istream& stream, const PartOfVdb& part);
/// `grid`: empty, of a type that is_readable(), as GridDescriptor::read() returns it.
void check_grid(std::istream& stream, const PartOfVdb& part, const openvdb::GridBase& grid);

/// Sets OpenVDB up, without metadata for delayed loading: it trusts their lengths, and we load at once.
void initialize();

/// Whether a grid has values of float, double or three floats. check_grid() knows only these.
bool is_readable(const openvdb::GridBase& grid);

}  // namespace offing::vdb
