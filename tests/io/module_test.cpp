#include "host/io/module.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <dlfcn.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <png.h>

#include "host/base/error.h"
#include "host/io/height_maps/read_height_map.h"
#include "tests/io/temporary_folder.h"

namespace offing {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string loaded_files() {
  std::ifstream maps("/proc/self/maps");
  return {std::istreambuf_iterator<char>(maps), {}};
}

class ModuleTest : public testing::Test {
 protected:
  void TearDown() override { unsetenv("OFFING_MODULE_PATH"); }

  // Modules are looked for here alone.
  void look_here() { setenv("OFFING_MODULE_PATH", folder_.path().c_str(), 1); }

  std::string refusal(const char* name) {
    try {
      module_table(name, "read maps");
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::file);
      EXPECT_THAT(error.hint(), HasSubstr("Offing"));
      return error.what();
    }
    return "none";
  }

  TemporaryFolder folder_;
};

// Fails if a program loads GDAL without need, or the module is not found beside the build's programs.
TEST_F(ModuleTest, IsLoadedWhenItIsNeeded) {
  EXPECT_THAT(loaded_files(), Not(HasSubstr("libgdal")));
  const std::filesystem::path map = folder_.path() / "map.asc";
  std::ofstream(map) << "ncols 2\nnrows 2\nxllcenter 0\nyllcenter 0\ncellsize 10\n1.5 2.5\n3.5 4.5\n";
  HeightMapOptions options;
  options.horizontal_unit = HorizontalUnit::metre;
  EXPECT_EQ(read_height_map(map, options).map.heights_m.at(3), 4.5f);
  EXPECT_THAT(loaded_files(), HasSubstr("libgdal"));
}

// Fails if a missing module is anything else than one line with the file that was looked for.
TEST_F(ModuleTest, NamesAMissingFile) {
  look_here();
  EXPECT_THAT(refusal("gdal"), HasSubstr("cannot read maps: " + (folder_.path() / "gdal.so").string()));
}

// Fails if a library that is no module, or one of another build, is called.
TEST_F(ModuleTest, RefusesWhatIsNoModule) {
  look_here();
  Dl_info png{};
  ASSERT_NE(dladdr(reinterpret_cast<const void*>(&png_access_version_number), &png), 0);
  std::filesystem::copy_file(std::filesystem::canonical(png.dli_fname), folder_.path() / "other.so");
  EXPECT_THAT(refusal("other"), HasSubstr("expected a module of this build of Offing"));
}

}  // namespace
}  // namespace offing
