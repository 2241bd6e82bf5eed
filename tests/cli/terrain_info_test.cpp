#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/cli/offing_program.h"
#include "tests/io/temporary_folder.h"

namespace offing::test {
namespace {

using ::testing::HasSubstr;

class TerrainInfo : public ::testing::Test {
 protected:
  TerrainInfo() {
    std::ofstream(file())
        << "ncols 3\nnrows 2\nxllcenter 1000\nyllcenter 5000\ncellsize 25\nNODATA_value -9999\n"
           "100 107 114\n153 -9999 167\n";
  }
  std::string file() const { return (folder_.path() / "grid.asc").string(); }

  TemporaryFolder folder_;
};

// Fails if scripts find another size, spacing, range or number of voids than the grid's text states.
TEST_F(TerrainInfo, TellsScripts) {
  const ProgramResult result = run_offing({"terrain", "info", file(), "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const auto json = nlohmann::json::parse(result.output);
  EXPECT_EQ(json["columns"], 3);
  EXPECT_EQ(json["rows"], 2);
  EXPECT_EQ(json["spacing_x_m"], 25.0);
  EXPECT_EQ(json["spacing_source"], "file");
  EXPECT_EQ(json["extent_x_m"], 50.0);
  EXPECT_EQ(json["lowest_m"], 100.0);
  EXPECT_EQ(json["highest_m"], 167.0);
  EXPECT_EQ(json["void_posts"], 1);
  EXPECT_EQ(json["void_area_m2"], 625.0);
  EXPECT_EQ(json["void_fill"], "pull-push");
  EXPECT_EQ(json["first_post"], nlohmann::json({1000.0, 5025.0}));
}

// Fails if the flags do not reach the reader, or a person is not told that voids were filled, and where from.
TEST_F(TerrainInfo, TellsPeople) {
  const ProgramResult result =
      run_offing({"terrain", "info", file(), "--scale", "2", "--offset-m=-50", "--spacing-x-m", "10"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(result.output, HasSubstr("3 x 2"));
  EXPECT_THAT(result.output, HasSubstr("10 m along x, 25 m along z"));
  EXPECT_THAT(result.output, HasSubstr("150 ... 284 m"));
  EXPECT_THAT(result.output, HasSubstr("1 post, 0.00025 km^2, filled from the posts around them"));
}

// Fails if a person is not told that metres of Web Mercator are not those of the ground: at 60 degrees they
// are twice as long.
TEST_F(TerrainInfo, TellsTheScaleOfMercator) {
  std::ofstream(file()) << "ncols 2\nnrows 2\nxllcenter 0\nyllcenter 8399725\ncellsize 26\n1 2\n3 4\n";
  std::ofstream((folder_.path() / "grid.prj").string())
      << "PROJCS[\"WGS_1984_Web_Mercator_Auxiliary_Sphere\",GEOGCS[\"GCS_WGS_1984\",DATUM[\"D_WGS_1984\","
         "SPHEROID[\"WGS_1984\",6378137.0,298.257223563]],PRIMEM[\"Greenwich\",0.0],UNIT[\"Degree\","
         "0.0174532925199433]],PROJECTION[\"Mercator_Auxiliary_Sphere\"],PARAMETER[\"False_Easting\",0.0],"
         "PARAMETER[\"False_Northing\",0.0],PARAMETER[\"Central_Meridian\",0.0],PARAMETER[\"Standard_"
         "Parallel_1\","
         "0.0],PARAMETER[\"Auxiliary_Sphere_Type\",0.0],UNIT[\"Meter\",1.0]]";
  const ProgramResult result = run_offing({"terrain", "info", file()});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(result.output, HasSubstr("13.0328 m along x"));
  EXPECT_THAT(result.output, HasSubstr("divided by the Mercator scale 1.995 at the middle row"));
}

// Fails if a bad file or flag is no error of usage or input with its two lines.
TEST_F(TerrainInfo, RefusesWithAHint) {
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{folder_.path().string()},
                                                    {file(), "--spacing-m", "0"},
                                                    {file(), "--band", "2"},
                                                    {file(), "--encoding", "morse"},
                                                    {file(), "--raw-size", "9"},
                                                    {file(), "--scale", "nan"}}) {
    std::vector<std::string> command{"terrain", "info"};
    command.insert(command.end(), arguments.begin(), arguments.end());
    const ProgramResult result = run_offing(command);
    EXPECT_EQ(result.exit_code, 2) << arguments.back();
    EXPECT_THAT(result.errors, ::testing::MatchesRegex("error: [^\n]+\nhint: [^\n]+\n")) << arguments.back();
    EXPECT_EQ(result.output, "");
  }
}

}  // namespace
}  // namespace offing::test
