#include "host/io/exr_image.h"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <random>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "tests/io/temporary_folder.h"

namespace offing {
namespace {

namespace fs = std::filesystem;
using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr float infinity = std::numeric_limits<float>::infinity();

std::string content(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string output_of(const std::string& command) {
  std::string output;
  FILE* const pipe = popen(command.c_str(), "r");
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) output.push_back(static_cast<char>(c));
  return pclose(pipe) == 0 ? output : "failed: " + output;
}

/// Two channels of 37 x 23 pixels (no multiple of a block) with every kind of finite float, and three
/// attributes.
class ExrImageTest : public ::testing::Test {
 protected:
  ExrImageTest() : first_(std::size_t{37} * 23), second_(std::size_t{37} * 23) {
    std::mt19937 random(7);
    std::normal_distribution<float> normal(0.0f, 3.0f);
    for (float& value : first_) value = normal(random);
    for (float& value : second_) value = 1e-3f * normal(random);
    first_[0] = 1e-40f;  // subnormal
    first_[1] = -0.0f;
    image_ = {37,
              23,
              {{"c0.displacement.Y", first_}, {"c1.jacobian_min_eigenvalue", second_}},
              {{"time_s", 0.1},
               {"seed", std::string("18446744073709551615")},
               {"frame", 3},
               {"empty", std::string()}}};
  }

  Error error_of_writing() {
    try {
      write_exr(folder_.path() / "bad.exr", image_, PixelType::float_32, ExrCompression::zip);
    } catch (const Error& error) {
      return error;
    }
    ADD_FAILURE() << "expected an Error";
    return {ErrorKind::device, "none"};
  }

  TemporaryFolder folder_;
  std::vector<float> first_, second_;
  ExrImage image_;
};

// Fails if any bit of a float is lost, or an attribute changes type or value, under any compression.
TEST_F(ExrImageTest, FloatsReturnBitForBit) {
  first_[5] = infinity;
  const fs::path path = folder_.path() / "a.exr";
  for (const ExrCompression compression :
       {ExrCompression::none, ExrCompression::zips, ExrCompression::zip, ExrCompression::piz}) {
    write_exr(path, image_, PixelType::float_32, compression);
    const ExrContent read = read_exr(path);
    ASSERT_EQ(read.width, 37);
    ASSERT_EQ(read.height, 23);
    ASSERT_EQ(read.channels.size(), 2u);
    EXPECT_EQ(std::memcmp(read.channel("c0.displacement.Y").data(), first_.data(), first_.size() * 4), 0);
    EXPECT_EQ(
        std::memcmp(read.channel("c1.jacobian_min_eigenvalue").data(), second_.data(), second_.size() * 4),
        0);
    for (const auto& attribute : image_.attributes) {
      EXPECT_THAT(read_exr_attributes(path), ::testing::Contains(attribute)) << attribute.first;
    }
  }
  EXPECT_THROW(read_exr(path).channel("c2.foam"), Error);
}

// Fails if OpenEXR does not read rows that we pack ourselves: more than wait in memory at once, noise that
// does not shrink, rows that do, 16-bit floats, names longer than EXR 1 had.
TEST_F(ExrImageTest, PackedRowsReturn) {
  constexpr int columns = 1200, rows = 300;
  std::vector<float> noise(std::size_t{columns} * rows), ramp(noise.size());
  std::mt19937 random(1);
  for (std::size_t i = 0; i < noise.size(); ++i) {
    const auto bits = static_cast<std::uint32_t>(random());
    std::memcpy(&noise[i], &bits, sizeof(bits));
    if (!std::isfinite(noise[i])) noise[i] = 0.0f;
    ramp[i] = static_cast<float>(i / columns);
  }
  const std::string long_name(200, 'n');
  const fs::path path = folder_.path() / "a.exr";
  std::map<std::pair<ExrCompression, bool>, std::uintmax_t> bytes;
  for (const PixelType pixel_type : {PixelType::float_32, PixelType::half_16}) {
    for (const ExrCompression compression : {ExrCompression::none, ExrCompression::zips}) {
      for (const std::vector<float>* values : {&noise, &ramp}) {
        write_exr(path, {columns, rows, {{"b", ramp}, {long_name, *values}}, {{long_name, 7}}}, pixel_type,
                  compression);
        const ExrContent read = read_exr(path);
        for (std::size_t i = 0; i < noise.size(); ++i) {
          const float expected =
              pixel_type == PixelType::half_16 ? rounded_to_half((*values)[i]) : (*values)[i];
          ASSERT_EQ(read.channel(long_name)[i], expected);
          ASSERT_EQ(read.channel("b")[i], ramp[i]);
        }
        bytes[{compression, values == &noise}] = fs::file_size(path);
      }
    }
  }
  EXPECT_LT(bytes.at({ExrCompression::zips, false}), bytes.at({ExrCompression::none, false}) / 20);
  EXPECT_LE(bytes.at({ExrCompression::zips, true}), bytes.at({ExrCompression::none, true}));
}

// Fails if halves are truncated instead of rounded, or large values become infinite.
// Bound: half an ulp of an 11-bit significand, 2^-11 relative (2^-25 absolute below 2^-14). Gate = bound:
// exact rounding.
TEST_F(ExrImageTest, HalvesRoundAndStayFinite) {
  first_[2] = 1e6f;
  first_[3] = -infinity;
  write_exr(folder_.path() / "a.exr", image_, PixelType::half_16, ExrCompression::zip);
  const std::vector<float> read = read_exr(folder_.path() / "a.exr").channel("c0.displacement.Y");
  EXPECT_EQ(read[2], 65504.0f);
  EXPECT_EQ(read[3], -65504.0f);
  for (std::size_t i = 4; i < read.size(); ++i) {
    ASSERT_LE(std::abs(read[i] - first_[i]), std::max(std::abs(first_[i]) * 0x1p-11f, 0x1p-25f)) << i;
  }
}

// Fails if a clock, a random name, the number of threads or the order of channels reaches the bytes.
TEST_F(ExrImageTest, EqualImagesGiveEqualBytes) {
  std::vector<float> big(std::size_t{512} * 512);
  std::mt19937 random(1);
  for (float& value : big) value = static_cast<float>(random()) * 1e-9f;
  ExrImage image{512, 512, {{"a", big}, {"b", big}}, {{"x", 1}, {"y", 2}}};
  for (const ExrCompression compression : {ExrCompression::zip, ExrCompression::zips}) {
    write_exr(folder_.path() / "first.exr", image, PixelType::float_32, compression);
    std::swap(image.channels[0], image.channels[1]);
    std::swap(image.attributes[0], image.attributes[1]);
    for (int repeat = 0; repeat < 5; ++repeat) {
      write_exr(folder_.path() / "second.exr", image, PixelType::float_32, compression);
      ASSERT_TRUE(content(folder_.path() / "first.exr") == content(folder_.path() / "second.exr"));
    }
  }
}

// Fails if OpenEXR's own tool does not see the layers and the header as documented.
TEST_F(ExrImageTest, ExrheaderReadsIt) {
  if (std::system("command -v exrheader > /dev/null") != 0)
    GTEST_SKIP() << "exrheader (package openexr) not found";
  write_exr(folder_.path() / "a.exr", image_, PixelType::half_16, ExrCompression::zip);
  const std::string listing = output_of("exrheader " + (folder_.path() / "a.exr").string());
  EXPECT_THAT(listing, HasSubstr("c0.displacement.Y, 16-bit floating-point"));
  EXPECT_THAT(listing, HasSubstr("time_s (type double): 0.1"));
  EXPECT_THAT(listing, HasSubstr("seed (type string): \"18446744073709551615\""));
  EXPECT_THAT(listing, HasSubstr("frame (type int): 3"));
  // OpenEXR 3.1 and 3.4 word it so.
  EXPECT_THAT(listing, AnyOf(HasSubstr("zip, multi-scanline blocks"),
                             HasSubstr("zip: zlib compression, in blocks of 16")));
}

// Fails if a broken simulation is written as if it were a frame, or the place of the NaN is wrong.
TEST_F(ExrImageTest, NanIsRefusedWithItsPlace) {
  second_[2 * 37 + 5] = std::nanf("");
  const Error error = error_of_writing();
  EXPECT_EQ(error.kind(), ErrorKind::bad_input);
  EXPECT_THAT(error.what(), HasSubstr("bad.exr: channel c1.jacobian_min_eigenvalue: NaN at row 2, column 5"));
  EXPECT_FALSE(fs::exists(folder_.path() / "bad.exr"));
}

// Fails if an image that EXR cannot hold gets past the check into OpenEXR.
TEST_F(ExrImageTest, MalformedImagesAreRefused) {
  const ExrImage good = image_;
  image_.width = 38;
  EXPECT_THAT(error_of_writing().what(), HasSubstr("expected 874 values, got 851"));
  image_ = good;
  image_.height = 0;
  EXPECT_THAT(error_of_writing().what(), HasSubstr("37x0"));
  image_ = good;
  image_.channels[1].name = image_.channels[0].name;
  EXPECT_THAT(error_of_writing().what(), HasSubstr("used twice"));
  image_ = good;
  image_.attributes.emplace_back("compression", 1);
  EXPECT_THAT(error_of_writing().what(), HasSubstr("one of EXR's own"));
  image_ = good;
  image_.attributes.emplace_back("frame", 4);
  EXPECT_THAT(error_of_writing().what(), HasSubstr("used twice"));
}

// Fails if a truncated or foreign file is taken for a frame that a resumed bake may keep.
TEST_F(ExrImageTest, BrokenFilesAreRefused) {
  const fs::path path = folder_.path() / "a.exr";
  write_exr(path, image_, PixelType::float_32, ExrCompression::zip);
  fs::resize_file(path, fs::file_size(path) / 2);
  EXPECT_THROW(read_exr(path), Error);
  std::ofstream(path) << "not an image";
  EXPECT_THROW(read_exr(path), Error);
  EXPECT_THROW(read_exr_attributes(path), Error);
  EXPECT_THROW(read_exr_attributes(folder_.path() / "missing.exr"), Error);
  EXPECT_THROW(write_exr(folder_.path() / "no" / "a.exr", image_, PixelType::float_32, ExrCompression::zip),
               Error);
}

// Fails if memory is taken for an image that its file cannot hold: here one 10^8 pixels wide.
TEST_F(ExrImageTest, HeadersThatPromiseTooMuchAreRefused) {
  const fs::path path = folder_.path() / "a.exr";
  write_exr(path, image_, PixelType::float_32, ExrCompression::zip);
  const std::string window("dataWindow\0box2i\0\x10\0\0\0", 21);
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  ASSERT_NE(bytes.find(window), std::string::npos);
  constexpr std::int32_t right = 100'000'000;
  file.seekp(static_cast<std::streamoff>(bytes.find(window) + window.size() + 2 * sizeof(right)));
  file.write(reinterpret_cast<const char*>(&right), sizeof(right));
  file.close();
  try {
    read_exr(path);
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("found a header for"));
  }
}

// Fails if OpenEXR's message, which has the name of a channel in it, is passed on with its line breaks.
TEST_F(ExrImageTest, NamesOfChannelsKeepMessagesInOneLine) {
  const fs::path path = folder_.path() / "a.exr";
  write_exr(path, image_, PixelType::float_32, ExrCompression::zip);
  std::string bytes = content(path);
  const std::size_t name = bytes.find("c0.displacement.Y");
  ASSERT_NE(name, std::string::npos);
  bytes[name + 16] = '\n';
  bytes[name + 17 + 1 + 8] =
      2;  // its subsampling along x, behind type and linearity: 37 columns have no half
  std::ofstream(path, std::ios::binary) << bytes;
  try {
    read_exr(path);
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("not a whole EXR file"));
    EXPECT_THAT(error.what(), Not(HasSubstr("\n")));
  }
}

// Fails if the library is asked for an attribute of 1.7 GB of a file that ends before: it takes the memory
// first.
TEST_F(ExrImageTest, AttributesBeyondTheFileAreRefused) {
  const fs::path path = folder_.path() / "a.exr";
  std::ofstream(path, std::ios::binary) << std::string(
      "\x76\x2f\x31\x01\2\0\0\0a\0b\0\0\0\0\x6a"
      "0",
      17);
  try {
    read_exr_attributes(path);
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("bytes in an attribute, found 1778384896"));
  }
  // An int of five bytes, of which the library reads four.
  std::ofstream(path, std::ios::binary) << std::string(
      "\x76\x2f\x31\x01\2\0\0\0a\0int\0\5\0\0\0"
      "00000\0",
      24);
  try {
    read_exr_attributes(path);
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("attribute of type int, found 5 bytes"));
  }
}

}  // namespace
}  // namespace offing
