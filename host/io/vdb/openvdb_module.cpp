#include "host/io/vdb/openvdb_module.h"

#include "host/io/module.h"

namespace offing::vdb {
namespace {

constexpr OpenvdbModule table{.write_vdb = write_vdb, .read_vdb = read_vdb};

}  // namespace
}  // namespace offing::vdb

OFFING_MODULE(offing::vdb::table);
