// Billboard textures of clouds from folders of pictures.
#include "host/scene/prepare/own_billboards.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/io/png_image.h"
#include "host/scene/file/scene_file.h"
#include "tests/io/temporary_folder.h"

namespace offing::scene {
namespace {

class OwnBillboardsTest : public testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::create_directory(folder_.path() / "mine");
    for (int i = 0; i < CLOUD_TEXTURES; ++i) write(i, 100 + 5 * i);
  }

  /// A picture with a bright left half.
  void write(int index, int brightness) const {
    RgbImage image{.width = 8, .height = 8, .rgb = {}};
    for (int i = 0; i < 64; ++i) {
      const auto byte = static_cast<std::uint8_t>(i % 8 < 4 ? brightness : 0);
      image.rgb.insert(image.rgb.end(), {byte, byte, byte});
    }
    write_png(folder_.path() / "mine" / fmt::format("puff_{:02}.png", index), image);
  }

  Scene scene(const std::string& text) const {
    return parse_scene("version = 1\n[clouds]\n" + text, "a.toml", folder_.path().string());
  }

  std::string message(const std::string& text) const {
    try {
      own_billboards(scene(text));
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_input);
      return error.what();
    }
    return "";
  }

  TemporaryFolder folder_;
};

// Fails if a folder is not found beside the scene, or if its pictures come to the wrong set or not at all.
TEST_F(OwnBillboardsTest, ReadsAFolder) {
  EXPECT_FALSE(own_billboards(scene("")));
  const clouds::BillboardTextures own = clouds::billboard_textures();
  const auto soft = own_billboards(scene("soft_billboards = \"mine\"\n"));
  ASSERT_TRUE(soft);
  const std::ptrdiff_t set = std::ptrdiff_t{CLOUD_TEXTURES} * CLOUD_TEXTURE_TEXELS;
  EXPECT_TRUE(std::equal(own.texels.begin(), own.texels.begin() + set, soft->texels.begin()));
  EXPECT_NE(own.texels, soft->texels);
  // Where the mean is 1/3 the bright half is denser: the third byte of texels left and right of the middle.
  const auto third = [&](int column) {
    return soft->texels[static_cast<std::size_t>(set) + 128 * CLOUD_TEXTURE_SIZE +
                        static_cast<std::size_t>(column)] >>
               16 &
           255u;
  };
  EXPECT_GT(third(64), third(192) + 50);
}

// Fails if a missing folder, one of too few pictures or a broken picture gives another error than a clear
// one.
TEST_F(OwnBillboardsTest, TellsWhatIsBroken) {
  EXPECT_THAT(message("crisp_billboards = \"nowhere\"\n"), testing::HasSubstr("a.toml:3"));
  std::filesystem::remove(folder_.path() / "mine" / "puff_03.png");
  EXPECT_THAT(message("crisp_billboards = \"mine\"\n"),
              testing::HasSubstr("expected 16 PNG files, found 15"));
  std::ofstream(folder_.path() / "mine" / "puff_03.png") << "\x89PNG, but not for long";
  EXPECT_THAT(message("crisp_billboards = \"mine\"\n"),
              testing::AllOf(testing::HasSubstr("a.toml:3"), testing::HasSubstr("puff_03.png"),
                             testing::HasSubstr("not a whole PNG file")));
}

}  // namespace
}  // namespace offing::scene
