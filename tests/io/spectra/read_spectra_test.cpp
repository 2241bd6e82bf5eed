#include "host/io/spectra/read_spectra.h"

#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include "host/io/spectra/gzip.h"
#include "tests/io/spectra/spectrum_checks.h"
#include "tests/io/temporary_folder.h"
#include "tests/ocl/expect_error.h"

namespace offing {
namespace {

using test::expect_error;
using test::write_text;

const std::string historical = "#YY  MM DD hh mm   .0500   .1000\n2020 01 02 03 40 1.0 2.0\n";
const std::string directions = "#YY  MM DD hh mm   .0500   .1000\n2020 01 02 03 40 200 210\n";
const std::string moments = "#YY  MM DD hh mm   .0500   .1000\n2020 01 02 03 40 70 30\n";
const std::string datawell =
    "10\n85\n4.5\n0.5\n25\n19\n7\n-0.1\n0.3\n0.2\n213\n68\n0.10,1.0,270,30,0,4\n0.11,0.5,270,30,0,4\n";

// Fails if a hostile name is taken for a format, a pattern, an address or a second line.
TEST(ReadSpectra, ReadsFilesOfHostileNames) {
  const TemporaryFolder folder;
  for (const char* name : {"buoy}2024-09-09T01h15Z.spt", "{} {0} %s %n.spt", "two\nlines.spt", "-o", "http:x",
                           "*?[a].nc", "\xff\xfe\x80.spt", "'\"`$(x)\\.txt"}) {
    const std::filesystem::path path = folder.path() / name;
    write_text(path, datawell);
    const auto spectra = read_spectra(path);
    ASSERT_EQ(spectra.size(), 1U) << name;
    EXPECT_EQ(spectra[0].energy[0], 0.5);
    write_text(path, datawell + "x\n");
    expect_error(ErrorKind::bad_input, ":15: expected f, S/Smax", [&] { read_spectra(path); });
  }
}

TEST(ReadSpectra, FindsHistoricalCompanions) {
  const TemporaryFolder folder;
  write_text(folder.path() / "46042w2020.txt", historical);
  EXPECT_FALSE(read_spectra(folder.path() / "46042w2020.txt")[0].is_directional());
  write_text(folder.path() / "46042d2020.txt", directions);
  write_text(folder.path() / "46042i2020.txt", directions);
  write_text(folder.path() / "46042j2020.txt", moments);
  EXPECT_TRUE(read_spectra(folder.path() / "46042w2020.txt")[0].is_directional());
  write_text(folder.path() / "46042k2020.txt", moments);
  EXPECT_TRUE(read_spectra(folder.path() / "46042w2020.txt")[0].is_directional());
  write_text(folder.path() / "46042k2020.txt", "damaged");
  expect_error(ErrorKind::bad_input, "46042k2020.txt:1: expected an NDBC header",
               [&] { read_spectra(folder.path() / "46042w2020.txt"); });
}

/// As one member of a gzip file.
std::string packed(const std::string& text) {
  z_stream stream{};
  deflateInit2(&stream, Z_BEST_SPEED, Z_DEFLATED, MAX_WBITS + 16, 8, Z_DEFAULT_STRATEGY);
  std::string bytes(deflateBound(&stream, text.size()), '\0');
  std::string input = text;
  stream.next_in = reinterpret_cast<Bytef*>(input.data());
  stream.avail_in = static_cast<uInt>(input.size());
  stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_out = static_cast<uInt>(bytes.size());
  deflate(&stream, Z_FINISH);
  bytes.resize(stream.total_out);
  deflateEnd(&stream);
  return bytes;
}

// NDBC's archive is compressed. Fails if such a file, its companions or its station are not found, or if a
// file of two members loses the second.
TEST(ReadSpectra, UnpacksGzip) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "46042w2020.txt.gz";
  const std::size_t half = historical.size() / 2;
  write_text(path, packed(historical.substr(0, half)) + packed(historical.substr(half)));
  EXPECT_FALSE(read_spectra(path)[0].is_directional());
  EXPECT_EQ(read_spectra(path)[0].station, "46042");
  write_text(folder.path() / "46042d2020.txt.gz", packed(directions));
  write_text(folder.path() / "46042j2020.txt.gz", packed(moments));
  EXPECT_TRUE(read_spectra(path)[0].is_directional());
  write_text(folder.path() / "buoy.spt.gz", packed(datawell));
  EXPECT_EQ(read_spectra(folder.path() / "buoy.spt.gz")[0].energy[0], 0.5);
}

// Fails if a small file can fill the memory, or a damaged one is read as a shorter one. 300 MB are 1.3 MB
// packed.
TEST(ReadSpectra, RefusesDamagedGzip) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "46042w2020.txt.gz";
  const std::string whole = packed(historical);
  for (const std::size_t length : {std::size_t{2}, std::size_t{12}, whole.size() - 5}) {
    write_text(path, whole.substr(0, length));
    expect_error(ErrorKind::bad_input, "46042w2020.txt.gz: expected a whole gzip file",
                 [&] { read_spectra(path); });
  }
  std::string bad_sum = whole;
  bad_sum[whole.size() - 6] ^= 1;
  write_text(path, bad_sum);
  expect_error(ErrorKind::bad_input, "expected a whole gzip file", [&] { read_spectra(path); });
  const std::string bomb = packed(std::string(3'000'000, ' '));
  EXPECT_LT(bomb.size(), 20'000u);
  expect_error(ErrorKind::bad_input, "b.gz: expected at most 1000000 bytes unpacked, got more",
               [&] { spectra::unpack_gzip(bomb, "b.gz", 1'000'000); });
}

// Fails if a file that is no spectrum is taken for one, or an error shows what is in it: a scene may name any
// file of the machine.
TEST(ReadSpectra, RefusesWhatIsNoSpectrum) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "f";
  expect_error(ErrorKind::bad_input, "f: expected a wave spectrum file, got no such file",
               [&] { read_spectra(path); });
  expect_error(ErrorKind::bad_input, "got a folder or device", [&] { read_spectra(folder.path()); });
  expect_error(ErrorKind::bad_input, "got a folder or device", [&] { read_spectra("/dev/null"); });
  expect_error(ErrorKind::bad_input, "got no such file", [&] { read_spectra(""); });
  constexpr const char* unknown = "f: expected a wave spectrum file, got a file of unknown format";
  const struct {
    std::string bytes;
    const char* message;
  } cases[] = {
      {"", "f: expected a wave spectrum file, got an empty file"},
      {"secret\n", unknown},
      {"# secret\n1 2 3\n", unknown},
      {"###", unknown},
      {"5\nsecret\n", unknown},
      {std::string(1000, '\0'), unknown},
      {"\x7f"
       "ELF\x02\x01\x01",
       unknown},
      {std::string(1 << 20, 'x'), unknown},
      {std::string(1 << 20, '\n'), unknown},
      {"CDF\x01", "f: expected a NetCDF file, but the header is cut short"},
      {"CDF", "f: expected a NetCDF file, but the header is cut short"},
      {"\x89HDF\r\n\x1a\n", "f: expected a NetCDF file, but opening it failed"},
      {"SWAN", "f:1: expected SWAN and the version 1"},
      {"'WAVEWATCH III SPECTRA'", "f:1: expected the number of frequencies, got the end of the file"},
      {"#YY", "f:1: expected the date columns"},
  };
  for (const auto& c : cases) {
    write_text(path, c.bytes);
    try {
      read_spectra(path);
      ADD_FAILURE() << c.message;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_input);
      EXPECT_THAT(error.what(), ::testing::HasSubstr(c.message));
      EXPECT_THAT(error.what(), ::testing::Not(::testing::HasSubstr("secret")));
      EXPECT_FALSE(error.hint().empty()) << c.message;
    }
  }
}

// Fails if a block of the user hides that an untrusted file is HDF5, which can lead to other files.
TEST(ReadSpectra, FindsHdf5BehindABlock) {
  const TemporaryFolder folder;
  for (const std::size_t block : {0, 512, 2048}) {
    write_text(folder.path() / "f.nc", std::string(block, ' ') + "\x89HDF\r\n\x1a\n");
    expect_error(ErrorKind::bad_input, "f.nc: expected a self-contained file, got HDF5",
                 [&] { read_spectra(folder.path() / "f.nc", Trust::untrusted); });
  }
}

TEST(ReadSpectra, NamesAFileThatMayNotBeRead) {
  if (geteuid() == 0) GTEST_SKIP() << "root may read everything";
  const TemporaryFolder folder;
  write_text(folder.path() / "f", historical);
  chmod((folder.path() / "f").c_str(), 0);
  expect_error(ErrorKind::bad_input, "f: cannot be read: Permission denied",
               [&] { read_spectra(folder.path() / "f"); });
}

}  // namespace
}  // namespace offing
