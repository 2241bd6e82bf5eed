#include "host/io/png_image.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include "host/base/error.h"
#include "tests/io/temporary_folder.h"

namespace offing {
namespace {

RgbImage ramp() {
  RgbImage image{31, 17, {}};
  for (int i = 0; i < 31 * 17 * 3; ++i) image.rgb.push_back(static_cast<std::uint8_t>(i * 7));
  return image;
}

std::string content(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// Fails if rows are flipped or padded, channels swapped or bytes changed by a colour conversion.
TEST(PngImage, PixelsReturn) {
  const TemporaryFolder folder;
  for (const PngCompression compression : {PngCompression::small, PngCompression::fast}) {
    write_png(folder.path() / "a.png", ramp(), Existing::replace, compression);
    const RgbImage read = read_png(folder.path() / "a.png");
    EXPECT_EQ(read.width, 31);
    EXPECT_EQ(read.height, 17);
    EXPECT_EQ(read.rgb, ramp().rgb);
  }
}

// Fails if a time stamp gets into the file, or the sRGB mark does not.
TEST(PngImage, EqualPicturesGiveEqualBytes) {
  const TemporaryFolder folder;
  for (const PngCompression compression : {PngCompression::small, PngCompression::fast}) {
    write_png(folder.path() / "a.png", ramp(), Existing::replace, compression);
    write_png(folder.path() / "b.png", ramp(), Existing::replace, compression);
    EXPECT_EQ(content(folder.path() / "a.png"), content(folder.path() / "b.png"));
    EXPECT_NE(content(folder.path() / "a.png").find("sRGB"), std::string::npos);
    EXPECT_EQ(content(folder.path() / "a.png").find("tIME"), std::string::npos);
  }
}

// Fails if the transfer function is a bare power or the ends leave 0 ... 255. Middle: 0.5 -> 187.5 of 255
// (IEC 61966-2-1).
TEST(PngImage, EncodesSrgb) {
  EXPECT_EQ(srgb_from_linear(0.0f), 0);
  EXPECT_EQ(srgb_from_linear(-1.0f), 0);
  EXPECT_EQ(srgb_from_linear(std::nanf("")), 0);
  EXPECT_EQ(srgb_from_linear(1.0f), 255);
  EXPECT_EQ(srgb_from_linear(9.0f), 255);
  EXPECT_EQ(srgb_from_linear(0.5f), 188);
  EXPECT_EQ(srgb_from_linear(0.002f),
            7);  // linear toe: 12.92 * 0.002 * 255 = 6.6; a power of 1/2.4 would give 5
}

// Fails if dithering moves a mean, or a value by a whole step, or black and white: 255 srgb(0.5) = 187.5.
// Over 64 x 64 pixels the noise has a mean of 0 to 0.01.
TEST(PngImage, DitheringKeepsMeans) {
  for (const float linear : {0.5f, 0.02f, 0.9f}) {
    const double exact = 255.0 * (1.055 * std::pow(static_cast<double>(linear), 1.0 / 2.4) - 0.055);
    double sum = 0.0;
    for (int i = 0; i < 64 * 64; ++i) {
      const int value = dithered_srgb(linear, dither_noise(i % 64, i / 64));
      EXPECT_LT(std::abs(value - exact), 1.0);
      sum += value;
    }
    EXPECT_NEAR(sum / (64 * 64), exact, 0.02);
  }
  for (const float noise : {-0.5f, 0.49f}) {
    EXPECT_EQ(dithered_srgb(0.0f, noise), 0);
    EXPECT_EQ(dithered_srgb(1.0f, noise), 255);
  }
}

// Fails if the lines that replace the curve give another byte than it does, for one in 1,000 of all floats.
TEST(PngImage, EncodesAsTheCurveDoes) {
  const auto by_curve = [](float linear, float noise) {
    const float encoded =
        linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
    return std::lround(std::clamp(255.0f * encoded + noise, 0.0f, 255.0f));
  };
  constexpr std::uint32_t one = std::bit_cast<std::uint32_t>(1.0f);
  for (std::uint32_t bits = std::bit_cast<std::uint32_t>(0.001f); bits < one; bits += 997) {
    const float linear = std::bit_cast<float>(bits);
    for (const float noise : {-0.5f, -0.31f, 0.0f, 0.4999f, 3.0f})
      ASSERT_EQ(dithered_srgb(linear, noise), by_curve(linear, noise)) << linear << " " << noise;
  }
}

// Fails if an empty picture, a wrong size, more pixels than libpng takes or a broken file goes unnoticed.
TEST(PngImage, BadInputIsRefused) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "a.png";
  constexpr int too_wide = 1'000'001;
  for (const PngCompression compression : {PngCompression::small, PngCompression::fast}) {
    const auto write = [&](const RgbImage& image) { write_png(file, image, Existing::replace, compression); };
    EXPECT_THROW(write({0, 4, {}}), Error);
    EXPECT_THROW(write({2, 2, std::vector<std::uint8_t>(11)}), Error);
    EXPECT_THROW(write({too_wide, 1, std::vector<std::uint8_t>(3 * too_wide)}), Error);
  }
  EXPECT_THROW(read_png(folder.path() / "missing.png"), Error);
  write_png(file, ramp());
  std::filesystem::resize_file(file, 100);
  EXPECT_THROW(read_png(file), Error);
}

// Fails if memory is taken for a picture that its file cannot hold: 30,000 x 30,000 pixels, of which there
// are none, and a right checksum.
TEST(PngImage, HeadersThatPromiseTooMuchAreRefused) {
  constexpr unsigned char bytes[] = {
      0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44, 0x52, 0x00,
      0x00, 0x75, 0x30, 0x00, 0x00, 0x75, 0x30, 0x08, 0x02, 0x00, 0x00, 0x00, 0xe9, 0x45, 0x6f, 0xed, 0x00,
      0x00, 0x00, 0x0b, 0x49, 0x44, 0x41, 0x54, 0x78, 0x9c, 0x63, 0x60, 0x80, 0x00, 0x00, 0x00, 0x08, 0x00,
      0x01, 0xb7, 0x58, 0x73, 0x95, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "a.png", std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes), sizeof(bytes));
  try {
    read_png(folder.path() / "a.png");
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("a header for 30000x30000"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace offing
