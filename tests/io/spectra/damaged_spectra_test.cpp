// Files cut at every byte, and files with bytes overwritten at random: each must give spectra that keep the
// contract, or an Error of one line that names the file.

#include <functional>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/io/spectra/datawell_spectra.h"
#include "host/io/spectra/ndbc_spectra.h"
#include "host/io/spectra/octopus_spectra.h"
#include "host/io/spectra/read_spectra.h"
#include "host/io/spectra/spotter_spectra.h"
#include "host/io/spectra/swan_spectra.h"
#include "host/io/spectra/triaxys_spectra.h"
#include "host/io/spectra/ww3_spectra.h"
#include "tests/io/spectra/spectrum_checks.h"
#include "tests/io/temporary_folder.h"

namespace offing::spectra {
namespace {

struct Format {
  const char* name;
  std::string text;
  std::function<std::vector<WaveSpectrum>(std::string_view)> parse;
};

NamedText named(std::string_view text) {
  return {text, "companion"};
}

std::vector<Format> formats() {
  static const std::string historical =
      "#YY  MM DD hh mm   .0500   .1000  .1500\n2020 01 02 03 40 1.0 2.0 999.0\n2020 01 02 04 40 99.00 99.00 "
      "99.00\n";
  static const std::string percent = "YY MM DD hh mm .05 .1 .15\n2020 01 02 03 40 70 30 50\n";
  return {
      {"realtime",
       "#YY  MM DD hh mm Sep_Freq  < spec_1 (freq_1) >\n2020 06 08 03 50 0.225 0.5 (0.05) 4 (0.1) MM "
       "(0.15)\r\n",
       [](std::string_view text) { return parse_ndbc(text, "f"); }},
      {"historical", historical,
       [](std::string_view text) {
         return parse_ndbc(text, "f", {named(percent), named(percent), named(percent), named(percent)});
       }},
      {"companion", percent,
       [](std::string_view text) {
         return parse_ndbc(historical, "f", {named(text), named(text), named(text), named(text)});
       }},
      {"ww3",
       "'WAVEWATCH III SPECTRA' 2 3 1 'grid'\n0.1 0.2\n 0.1 2.2 4.3\n20220912 060000\n'A' 40.9-171.1 46.6 1 "
       "2 3 4\n"
       " 0.4E+01 0 0.1-104 1D0 2 3\n",
       [](std::string_view text) { return parse_ww3(text, "f"); }},
      {"swan 2-D",
       "SWAN 1\n$ x\nTIME\n 1\nLONLAT\n 2\n 1 5\n 1 6\nAFREQ\n 2\n .1\n .2\nNDIR\n 3\n 10\n 20\n 30\nQUANT\n "
       "1\n"
       "VaDens\nm2/Hz/degr\n -99\n20161011.000000\nFACTOR\n .5E-1\n 0 1 2\n 3 4 "
       "-99\nZERO\n20161012.000000\nNODATA\n"
       "FACTOR\n 1\n 1 1 1\n 1 1 1\n",
       [](std::string_view text) { return parse_swan(text, "f"); }},
      {"swan 1-D",
       "SWAN 1\nLOCATIONS\n 1\n 1 5\nRFREQ\n 2\n .1\n .2\nQUANT\n 3\nVaDens\nm2/Hz\n -99\nCDIR\ndegr\n -999\n"
       "DSPRDEGR\ndegr\n -9\nLOCATION 1\n 1 90 30\n 2 -999 -9\n",
       [](std::string_view text) { return parse_swan(text, "f"); }},
      {"datawell",
       "10\r\n85\r\n4\r\n.5\r\n25\r\n19\r\n7\r\n-1\r\n3\r\n2\r\n213\r\n68\r\n0.1,1.0,270,30,-1,4\r\n.2,5E-1,"
       "0,70,0,9\r\n",
       [](std::string_view text) { return parse_datawell(text, "f"); }},
      {"triaxys 1-D",
       "TRIAXYS BUOY DATA REPORT - A - B\nTYPE = NON-DIRECTIONAL SPECTRUM\nDATE = 2018-01-31 21:00(UTC)\n"
       "NUMBER OF FREQUENCIES = 3\nCOLUMN 1 = FREQUENCY (Hz)\n0.0 0\n0.1 1E-2\n0.2 2.5\n",
       [](std::string_view text) { return parse_triaxys(text, "f"); }},
      {"triaxys 2-D",
       "TRIAXYS BUOY DATA REPORT\nTYPE\t= DIRECTIONAL SPECTRUM\nNUMBER OF FREQUENCIES = 2\n"
       "INITIAL FREQUENCY (Hz) = .1\nFREQUENCY SPACING (Hz) = .1\nDIRECTION SPACING (DEG) = 120\n"
       "ROWS = 0\n 0 1 2 0\n 0 1E0 0 0\n",
       [](std::string_view text) { return parse_triaxys(text, "f"); }},
      {"octopus",
       "Forecast valid for 11-Mar-2018 00:00:00\nnfreqs,2\nndir,3\nnrecs,1\nLatitude,-39\nLongitude,173\n"
       "Depth,102.5\n\nCCYYMM,DDHHmm,LPoint\n201803,'110600,a_20180311_06z\nfreq,.1,.2,anspec\n0,0,1,1,\n"
       "120,2,0,2,\n240,0,0,0,\nfSpec,2,1,\nden,2,1,\n",
       [](std::string_view text) { return parse_octopus(text, "f"); }},
      {"spotter JSON",
       "{\"data\":{\"spotterId\":\"S\",\"frequencyData\":[{\"frequency\":[0.1,0.2],\"varianceDensity\":[1,2],"
       "\"a1\":[0.5,0.1],\"b1\":[0,0.1],\"a2\":[0.2,null],\"b2\":[0,0],\n\"direction\":[270,90],"
       "\"directionalSpread\":[40,50],\"timestamp\":\"2018-02-14T00:27:19.000Z\"}]}}",
       [](std::string_view text) { return parse_spotter(text, "f"); }},
      {"spotter CSV",
       "Epoch Time ,f_0 ,f_1 ,varianceDensity_0 ,varianceDensity_1 ,direction_0 ,direction_1 "
       ",directionalSpread_0 ,directionalSpread_1\n1518568039 ,0.1 ,0.2 ,1 ,2 ,270 ,- ,40 ,50\n",
       [](std::string_view text) { return parse_spotter(text, "f"); }},
  };
}

void expect_spectra_or_error(const Format& format, const std::string& text) {
  try {
    const auto spectra = format.parse(text);
    EXPECT_FALSE(spectra.empty());
    for (const WaveSpectrum& spectrum : spectra) test::expect_contract(spectrum);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    EXPECT_EQ(std::string_view(error.what()).find('\n'), std::string_view::npos);
    EXPECT_FALSE(error.hint().empty()) << error.what();
  }
}

TEST(DamagedSpectra, WholeFilesAreRead) {
  for (const Format& format : formats()) EXPECT_NO_THROW(format.parse(format.text)) << format.name;
}

// Fails if a format is not known by its content alone, whatever the name of its file.
TEST(DamagedSpectra, NewFormatsAreKnownByContent) {
  const TemporaryFolder folder;
  for (const Format& format : formats()) {
    const std::string_view name = format.name;
    if (!name.starts_with("triaxys") && !name.starts_with("octopus") && !name.starts_with("spotter"))
      continue;
    test::write_text(folder.path() / "f", format.text);
    EXPECT_EQ(read_spectra(folder.path() / "f")[0].energy, format.parse(format.text)[0].energy) << name;
  }
}

TEST(DamagedSpectra, EveryPrefixIsReadOrRefused) {
  for (const Format& format : formats()) {
    SCOPED_TRACE(format.name);
    for (std::size_t length = 0; length < format.text.size(); ++length) {
      expect_spectra_or_error(format, format.text.substr(0, length));
    }
  }
}

TEST(DamagedSpectra, OverwrittenBytesAreReadOrRefused) {
  constexpr std::string_view bytes = "0123456789.-+eEdD ,()'#$\n\r\t\0\xff nainfZERO";
  std::mt19937 random(7);
  for (const Format& format : formats()) {
    SCOPED_TRACE(format.name);
    for (int i = 0; i < 3000; ++i) {
      std::string text = format.text;
      for (unsigned count = 1 + random() % 4; count > 0; --count)
        text[random() % text.size()] = bytes[random() % bytes.size()];
      expect_spectra_or_error(format, text);
    }
  }
}

}  // namespace
}  // namespace offing::spectra
