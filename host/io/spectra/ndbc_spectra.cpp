#include "host/io/spectra/ndbc_spectra.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/io/spectra/bearings.h"
#include "host/io/spectra/gzip.h"
#include "host/io/spectra/ndbc_table.h"
#include "host/io/spectra/spectrum_builder.h"
#include "host/io/spectra/text_cursor.h"

namespace offing::spectra {
namespace {

// Companions print the same frequencies; half the last of three digits tells neighbours (0.005 Hz apart)
// apart.
constexpr double same_frequency_hz = 0.0005 + 1e-9;

[[noreturn]] void fail_in_row(std::string_view file_name, const NdbcRow& row, const std::string& what,
                              const std::string& hint) {
  throw Error(ErrorKind::bad_input,
              fmt::format("{}:{}: {}", printable_name(file_name), row.line_number, what), hint);
}

/// One companion file, its rows found by time.
class Companion {
 public:
  Companion(const std::optional<NamedText>& source, NdbcQuantity quantity, double lowest, double highest) {
    if (!source) return;
    file_name_ = source->file_name;
    table_ = parse_ndbc_table(source->text, file_name_);
    if (table_.quantity != NdbcQuantity::unstated && table_.quantity != quantity) {
      throw Error(ErrorKind::bad_input,
                  fmt::format("{}:1: expected the columns that the file's name promises, got others",
                              printable_name(file_name_)),
                  "companions of a .data_spec file are .swdir (alpha1), .swdir2 (alpha2), .swr1 and .swr2");
    }
    for (const NdbcRow& row : table_.rows) {
      row_of_time_.emplace(row.time, &row);
      for (const NdbcSample& sample : row.samples) {
        if (!sample.value) continue;
        largest_ = std::max(largest_, *sample.value);
        if (*sample.value < lowest || *sample.value > highest) {
          fail_in_row(
              file_name_, row,
              fmt::format("expected a value within [{:g}, {:g}], got {:g}", lowest, highest, *sample.value),
              "missing values are written 999");
        }
      }
    }
  }

  const NdbcRow* row_at(const UtcTime& time) const {
    const auto found = row_of_time_.find(time);
    return found == row_of_time_.end() ? nullptr : found->second;
  }

  double largest() const { return largest_; }

 private:
  std::string file_name_;
  NdbcTable table_;
  std::map<UtcTime, const NdbcRow*> row_of_time_;
  double largest_ = 0.0;
};

std::optional<double> value_at(const NdbcRow* row, double frequency_hz) {
  if (!row) return std::nullopt;
  const auto found =
      std::lower_bound(row->samples.begin(), row->samples.end(), frequency_hz - same_frequency_hz,
                       [](const NdbcSample& sample, double f_hz) { return sample.frequency_hz < f_hz; });
  if (found == row->samples.end() || found->frequency_hz > frequency_hz + same_frequency_hz)
    return std::nullopt;
  return found->value;
}

/// alpha_n and r_n of one order n: the moments of where waves travel to.
class MomentFiles {
 public:
  MomentFiles(int order, const std::optional<NamedText>& alpha, NdbcQuantity alpha_quantity,
              const std::optional<NamedText>& r, NdbcQuantity r_quantity)
      : order_(order),
        alpha_(alpha, alpha_quantity, 0.0, 360.0),
        r_(r, r_quantity, 0.0, 100.0),
        r_unit_(r_.largest() > 1.5 ? 0.01 : 1.0) {}

  std::optional<std::complex<double>> moment(const UtcTime& time, double frequency_hz) const {
    const std::optional<double> alpha_deg = value_at(alpha_.row_at(time), frequency_hz);
    const std::optional<double> r = value_at(r_.row_at(time), frequency_hz);
    if (!alpha_deg || !r) return std::nullopt;
    return std::polar(*r * r_unit_, order_ * direction_from_origin_bearing(*alpha_deg * degree_rad));
  }

 private:
  int order_;
  Companion alpha_;
  Companion r_;
  double r_unit_;
};

// "41010" of 41010.data_spec and of 41010w2020.txt.
std::string station_name(std::string_view file_name) {
  const std::filesystem::path path = unpacked_name(std::string(file_name));
  std::string stem = path.stem().string();
  if (const auto companions = ndbc_companion_paths(path); companions && path.extension() == ".txt") {
    stem.resize(stem.size() - 5);
  }
  return stem;
}

WaveSpectrum read_energy(const NdbcRow& row, std::string_view file_name) {
  WaveSpectrum spectrum;
  spectrum.time_utc = iso_time(row.time).value_or("");
  for (const NdbcSample& sample : row.samples) {
    if (!sample.value) continue;
    if (*sample.value < 0.0) {
      fail_in_row(file_name, row,
                  fmt::format("expected a variance density >= 0 m^2/Hz, got {:g} at {:g} Hz", *sample.value,
                              sample.frequency_hz),
                  "missing values are written 999");
    }
    spectrum.frequencies_hz.push_back(sample.frequency_hz);
    spectrum.energy.push_back(*sample.value);
  }
  return spectrum;
}

}  // namespace

std::vector<WaveSpectrum> parse_ndbc(std::string_view text, std::string_view file_name,
                                     const NdbcCompanions& companions) {
  const NdbcTable table = parse_ndbc_table(text, file_name);
  if (table.quantity != NdbcQuantity::energy && table.quantity != NdbcQuantity::unstated) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}:1: expected spectral densities, got directions or their moments",
                            printable_name(file_name)),
                "give the .data_spec file; its .swdir .swdir2 .swr1 .swr2 companions are found beside it");
  }
  const MomentFiles first(1, companions.alpha1, NdbcQuantity::alpha1, companions.r1, NdbcQuantity::r1);
  const MomentFiles second(2, companions.alpha2, NdbcQuantity::alpha2, companions.r2, NdbcQuantity::r2);
  const std::string station = station_name(file_name);

  std::vector<WaveSpectrum> spectra;
  for (const NdbcRow& row : table.rows) {
    WaveSpectrum spectrum = read_energy(row, file_name);
    if (spectrum.frequencies_hz.size() < 2) continue;
    spectrum.station = station;
    std::vector<ReportedMoments> moments(spectrum.frequencies_hz.size());
    for (std::size_t i = 0; i < moments.size(); ++i) {
      const auto c1 = first.moment(row.time, spectrum.frequencies_hz[i]);
      const auto c2 = second.moment(row.time, spectrum.frequencies_hz[i]);
      if (!c1) continue;
      moments[i].kind = c2 ? ReportedMoments::Kind::both : ReportedMoments::Kind::first;
      moments[i].moments = {*c1, c2.value_or(0.0)};
    }
    set_moments(spectrum, moments);
    spectra.push_back(std::move(spectrum));
  }
  if (spectra.empty()) {
    throw Error(
        ErrorKind::bad_input,
        fmt::format("{}: expected at least one row with two densities, got none", printable_name(file_name)),
        "the file holds no data or only missing values; choose another month or station");
  }
  return spectra;
}

std::optional<NdbcCompanionPaths> ndbc_companion_paths(const std::filesystem::path& path) {
  if (path.extension() == ".data_spec") {
    const auto with = [&](const char* extension) {
      std::filesystem::path other = path;
      return other.replace_extension(extension);
    };
    return NdbcCompanionPaths{with(".swdir"), with(".swdir2"), with(".swr1"), with(".swr2")};
  }
  const std::string stem = path.stem().string();
  if (path.extension() != ".txt" || stem.size() < 6) return std::nullopt;
  const std::size_t letter = stem.size() - 5;
  const bool has_year = std::all_of(stem.begin() + static_cast<std::ptrdiff_t>(letter) + 1, stem.end(),
                                    [](char c) { return c >= '0' && c <= '9'; });
  if (stem[letter] != 'w' || !has_year) return std::nullopt;
  const auto with = [&](char other_letter) {
    std::string other = stem;
    other[letter] = other_letter;
    return path.parent_path() / (other + ".txt");
  };
  return NdbcCompanionPaths{with('d'), with('i'), with('j'), with('k')};
}

}  // namespace offing::spectra
