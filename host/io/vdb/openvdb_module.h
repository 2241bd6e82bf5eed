#pragma once

#include "host/io/vdb/vdb_volume.h"

namespace offing::vdb {

/// The functions of the module `openvdb`.
struct OpenvdbModule {
  decltype(&offing::write_vdb) write_vdb;
  decltype(&offing::read_vdb) read_vdb;
};

}  // namespace offing::vdb
