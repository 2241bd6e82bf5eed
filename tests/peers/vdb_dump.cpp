// vdb_dump FILE.vdb FILE.raw: what OpenVDB reads of a cloud, for programs that cannot read .vdb files.
// FILE.raw: floats [z][y][x] of the box of active cells of the grid `density` and one cell around it. Prints
// the number of cells along x, y, z, the middle of the first cell in m, the length of a cell in m, and
// extinction_per_m.
#include <cstdio>
#include <fstream>

#include <openvdb/openvdb.h>

int main(int count, char** arguments) {
  if (count != 3) return 2;
  openvdb::initialize();
  openvdb::io::File file(arguments[1]);
  file.open();
  const auto grid = openvdb::gridPtrCast<openvdb::FloatGrid>(file.readGrid("density"));
  openvdb::CoordBBox box = grid->evalActiveVoxelBoundingBox();
  box.expand(1);
  std::ofstream raw(arguments[2], std::ios::binary);
  const auto values = grid->getConstAccessor();
  for (int z = box.min().z(); z <= box.max().z(); ++z) {
    for (int y = box.min().y(); y <= box.max().y(); ++y) {
      for (int x = box.min().x(); x <= box.max().x(); ++x) {
        const float value = values.getValue({x, y, z});
        raw.write(reinterpret_cast<const char*>(&value), sizeof(value));
      }
    }
  }
  const openvdb::Coord size = box.dim();
  const openvdb::Vec3d first_m = grid->indexToWorld(box.min());
  std::printf("%d %d %d %.17g %.17g %.17g %.17g %.17g\n", size.x(), size.y(), size.z(), first_m.x(),
              first_m.y(), first_m.z(), grid->voxelSize().x(), grid->metaValue<double>("extinction_per_m"));
  return raw.good() ? 0 : 1;
}
