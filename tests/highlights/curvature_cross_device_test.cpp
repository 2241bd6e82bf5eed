// The same kernels under Oclgrind, which checks every access, in a process of its own.
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include "tests/io/temporary_folder.h"

namespace offing {
namespace {

// Fails if a work-item reads or writes outside a buffer, two race, or results differ from those of the host.
TEST(CurvatureCrossDeviceTest, OclgrindReportsNothing) {
  if (std::system("command -v oclgrind > /dev/null 2>&1") != 0) GTEST_SKIP() << "oclgrind is not installed";
  const TemporaryFolder folder;
  const std::string log = (folder.path() / "log").string(), output = (folder.path() / "output").string();
  const auto text_of = [](const std::string& path) {
    std::ifstream file(path);
    return std::string{std::istreambuf_iterator<char>(file), {}};
  };
  const std::string command = "OFFING_CACHE_DIR=" + (folder.path() / "cache").string() +
                              " oclgrind --data-races --log " + log + " " + OFFING_DIFFUSED_CURVATURE_TEST +
                              " --gtest_filter='DiffusedCurvatureTest.*' > " + output + " 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << text_of(output);
  EXPECT_EQ(text_of(log), "");
}

}  // namespace
}  // namespace offing
