#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace offing::spectra {

/// Walks the header of a classic NetCDF file (CDF-1, CDF-2, CDF-5) and says what is wrong with it: lengths
/// and offsets that do not fit the file's size, dimensions that do not exist. Empty if it is sound, and for
/// everything that does not start with "CDF". libnetcdf trusts these lengths: a damaged one makes it allocate
/// or read beyond bounds, so nothing unsound reaches it. Source: NetCDF classic format specification
/// (Unidata), the grammar in BNF.
std::string classic_header_fault(std::span<const std::byte> bytes);

}  // namespace offing::spectra
