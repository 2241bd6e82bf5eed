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
#include "host/io/spectra/swan_spectra.h"
#include "host/io/spectra/ww3_spectra.h"
#include "tests/io/spectra/spectrum_checks.h"

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
