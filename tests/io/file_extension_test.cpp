#include "host/io/file_extension.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/base/error.h"

namespace offing {
namespace {

// Fails if a picture may be given a name that promises another format, or the fix is not the name that fits.
TEST(FileExtension, IsThatOfTheFormat) {
  EXPECT_NO_THROW(require_extension("a/b.png", {".png"}));
  EXPECT_NO_THROW(require_extension("a/b.exr", {".png", ".exr"}));
  for (const char* name : {"a/b.jpg", "a/b", "a/b.png.jpg", "a/bpng"}) {
    try {
      require_extension(name, {".png", ".exr"});
      ADD_FAILURE() << name;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_usage);
      EXPECT_EQ(error.what(), std::string(name) + ": expected a name that ends in .png or .exr");
      EXPECT_TRUE(error.hint().ends_with(".png")) << error.hint();
    }
  }
}

// Fails if the hint for standard output is a file named -.png.
TEST(FileExtension, OfPicturesOnStandardOutput) {
  try {
    require_extension("-", {".png"});
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.hint(), "name it out.png");
  }
}

// Fails if CSV is written under the name of a GIS format, or other names are refused.
TEST(FileExtension, OfVectorFormats) {
  for (const char* name : {"a/b.gpkg", "a/b.GPKG", "a/b.csv", "a/b.txt", "a/b", "-", ""})
    EXPECT_NO_THROW(refuse_vector_name(name, {".gpkg", ".csv"})) << name;
  for (const char* extension :
       {".geojson", ".json", ".shp", ".kml", ".kmz", ".gml", ".fgb", ".gpx", ".dxf", ".SHP"}) {
    try {
      refuse_vector_name(std::string("a/b") + extension, {".gpkg", ".csv"});
      ADD_FAILURE() << extension;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_usage);
      EXPECT_THAT(error.what(), ::testing::HasSubstr("expected a name that ends in .gpkg or .csv, found ."));
      EXPECT_EQ(error.hint(), "name it b.gpkg or b.csv");
    }
  }
  EXPECT_THROW(refuse_vector_name("b.gpkg", {".csv"}), Error);
}

TEST(FileExtension, InLowerCase) {
  EXPECT_EQ(lower_extension("A.B/c.D.PnG"), ".png");
  EXPECT_EQ(lower_extension("A.B/.Hidden"), "");
}

}  // namespace
}  // namespace offing
