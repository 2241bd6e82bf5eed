// The functions of vdb_volume.h as the module `openvdb` has them.
#include "host/io/module.h"
#include "host/io/vdb/openvdb_module.h"

namespace offing {
namespace {

const vdb::OpenvdbModule& openvdb() {
  return module_functions<vdb::OpenvdbModule>("openvdb", "read or write VDB files");
}

}  // namespace

void write_vdb(const std::filesystem::path& path, const VdbCloud& cloud, VdbPrecision precision,
               Existing existing) {
  openvdb().write_vdb(path, cloud, precision, existing);
}

VdbCloud read_vdb(const std::filesystem::path& path, std::string_view grid, const VdbLimits& limits) {
  return openvdb().read_vdb(path, grid, limits);
}

}  // namespace offing
