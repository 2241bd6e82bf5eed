// Files of others, read by the program with --untrusted.
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/offing_program.h"
#include "tests/io/local_server.h"
#include "tests/io/temporary_folder.h"

namespace offing::test {
namespace {

class Untrusted : public ::testing::Test {
 protected:
  Untrusted() { std::filesystem::create_directory(path("own")); }

  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
  }

  TemporaryFolder folder_;
};

// Fails if a command that reads scenes, maps or spectra does not take --untrusted, or does not hand it on.
TEST_F(Untrusted, IsKeptByEveryCommand) {
  const std::string scene =
      write("own/a.toml", "version = 1\n[ocean]\nspectrum_file = '../b.data_spec'\n[[cloud]]\n[[mesh]]\n");
  const std::string map = write("own/a.vrt",
                                "<VRTDataset rasterXSize=\"2\" rasterYSize=\"2\"><VRTRasterBand band=\"1\">"
                                "<SimpleSource><SourceFilename relativeToVRT=\"1\">../b.asc</SourceFilename>"
                                "</SimpleSource></VRTRasterBand></VRTDataset>");
  write("b.asc", "ncols 2\nnrows 2\nxllcenter 0\nyllcenter 0\ncellsize 20\n1 2\n3 4\n");
  const std::string out = path("out"), vdb = path("out.vdb"), json = path("out.json"), png = path("out.png"),
                    tif = path("out.tif");
  const std::string height = path("b.data_spec");
  const std::string header = "#YY  MM DD hh mm Sep_Freq  < spec_1 (freq_1) spec_2 (freq_2) ... >\n";
  const std::string spectrum =
      write("own/b.data_spec", header + "2020 06 08 03 50 0.225 0.100 (0.100) 2.000 (0.200)\n");
  write("b.swdir", header);
  std::filesystem::create_symlink(path("b.swdir"), path("own/b.swdir"));
  const std::vector<std::vector<std::string>> commands{
      {"ocean", "stats", scene},
      {"ocean", "bake", scene, "-o", out},
      {"ocean", "query", scene, "--at", "0,0"},
      {"ocean", "spectrum", spectrum},
      {"highlights", scene, "-o", json},
      {"clouds", "build", scene, "-o", vdb},
      {"clouds", "info", scene},
      {"terrain", "info", map},
      {"terrain", "height", map, "--at", "0,0"},
      {"terrain", "tile", map, "-o", out},
      {"terrain", "viewshed", map, "--observer", "0,0", "-o", tif},
      {"terrain", "render", map, "-o", png}};
  for (std::vector<std::string> command : commands) {
    command.emplace_back("--untrusted");
    const ProgramResult result = run_offing(command);
    EXPECT_EQ(result.exit_code, 2) << command[0] << " " << command[1];
    EXPECT_THAT(result.errors, ::testing::HasSubstr("found one outside")) << command[0] << " " << command[1];
    EXPECT_THAT(result.errors, ::testing::MatchesRegex("error: [^\n]+\nhint: [^\n]+\n"));
  }
}

// Fails if the program asks a server for anything that a scene, a map or a coordinate system names, or shows
// what is in a file that is no spectrum.
TEST_F(Untrusted, LeadsToNoServerAndShowsNoFile) {
  const LocalServer server;
  const std::string url = server.url();
  const std::string secret = write("secret", "# key = hunter2\n");
  const std::string wms = fmt::format(
      "<GDAL_WMS><Service name=\"WMS\"><ServerUrl>{}/?</ServerUrl></Service>"
      "<DataWindow><SizeX>9</SizeX><SizeY>9</SizeY></DataWindow></GDAL_WMS>",
      url);
  write("wms.tif", wms);
  for (const std::string& content :
       {"[terrain]\nfile = '/vsicurl/" + url + "/a.tif'\n", "[terrain]\ncolour = '" + url + "/a.tif'\n",
        "[ocean]\nspectrum_file = '" + url + "/a.nc'\n", "[ocean]\nspectrum_file = '" + secret + "'\n"}) {
    const ProgramResult result = run_offing({"ocean", "stats", write("a.toml", "version = 1\n" + content)});
    EXPECT_EQ(result.exit_code, 2) << content;
    EXPECT_THAT(result.errors, ::testing::Not(::testing::HasSubstr("hunter2"))) << content;
  }
  for (const std::string& map : {path("wms.tif"), "/vsicurl/" + url + "/a.tif"}) {
    EXPECT_EQ(run_offing({"terrain", "info", map}).exit_code, 2);
  }
  write("b.asc", "ncols 2\nnrows 2\nxllcenter 0\nyllcenter 0\ncellsize 0.01\n1 2\n3 4\n");
  write("b.prj",
        "GEOGCS[\"GCS_WGS_1984\",DATUM[\"D_WGS_1984\",SPHEROID[\"WGS_1984\",6378137,298.257223563]],"
        "PRIMEM[\"Greenwich\",0],UNIT[\"Degree\",0.0174532925199433]]");
  EXPECT_EQ(run_offing({"terrain", "info", path("b.asc"), "--reproject", url + "/system"}).exit_code, 2);
  EXPECT_EQ(server.callers(), 0);
}

}  // namespace
}  // namespace offing::test
