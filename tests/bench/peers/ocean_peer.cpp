// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#include "tests/bench/peers/ocean_peer.h"

#include <algorithm>
#include <cstring>

#include <fmt/format.h>

#include "kernels/shared/mode_layout.h"

namespace offing::bench {
namespace {

constexpr int fields = 4;
constexpr int most_padding = 8;  // complex numbers, one line of cache: 16 was no faster

}  // namespace

OceanPeer::OceanPeer(const ocean::WaveModes& modes, int cascade, float choppiness)
    : size_(modes.size()),
      mode_rows_(modes.size() / 2),
      choppiness_(choppiness),
      wavenumber_step_radpm_(modes.wavenumber_step().read()[static_cast<std::size_t>(cascade)]),
      amplitude_(static_cast<std::size_t>(fields) * mode_rows_ * size_),
      rate_(static_cast<std::size_t>(mode_rows_) * size_),
      spectra_(fields * field_floats(size_ + most_padding)),
      displacement_(static_cast<std::size_t>(4) * size_ * size_),
      gradient_(displacement_.size()) {
  read_modes(modes, cascade);

  using peer::Stores;
  for (const int padding : {0, most_padding}) {
    const int pitch = size_ + padding;
    for (const Cores cores : {Cores::share_transforms, Cores::take_one_each}) {
      const bool shared = cores == Cores::share_transforms;
      for (const Stores stores : {Stores::cached, Stores::streaming}) {
        // The second plan of a shape costs nothing: FFTW remembers.
        ways_.push_back(
            {FftwPlan({.size = size_, .batch = shared ? fields : 1, .pitch = pitch}, spectra_.data(),
                      spectra_.data(), shared && core_count() > 1 ? Threading::openmp : Threading::one),
             pitch, cores, stores});
      }
    }
  }
}

// The device keeps columns with kx >= 0 (kernels/shared/mode_layout.h); the peer works on rows with kz >= 0.
// P(-K) and Q(-K) are the conjugates of P(K) and Q(K).
void OceanPeer::read_modes(const ocean::WaveModes& modes, int cascade) {
  const auto n = static_cast<std::size_t>(size_);
  const std::size_t device_plane = mode_plane_size(modes.columns(), size_);
  std::vector<float> amplitude(fields * device_plane);
  std::vector<std::uint32_t> rate(device_plane);
  modes.amplitude().read(amplitude, fields * device_plane * static_cast<std::size_t>(cascade));
  modes.rate().read(rate, device_plane * static_cast<std::size_t>(cascade));
  for (int row = 0; row < mode_rows_; ++row) {
    for (int column = 0; column < size_; ++column) {
      if (column == size_ / 2) continue;  // Nyquist: stays zero
      const bool is_partner = column > size_ / 2;
      const int from_row = is_partner ? (size_ - row) % size_ : row;
      const int from_column = is_partner ? size_ - column : column;
      const std::size_t from = mode_place(from_row, from_column, size_);
      const std::size_t to = static_cast<std::size_t>(row) * n + static_cast<std::size_t>(column);
      rate_[to] = rate[from];
      for (std::size_t field = 0; field < fields; ++field) {
        const float sign = is_partner && field % 2 == 1 ? -1.0f : 1.0f;
        amplitude_.data()[field * rate_.size() + to] = sign * amplitude[field * device_plane + from];
      }
    }
  }
}

std::size_t OceanPeer::field_floats(int pitch) const {
  return static_cast<std::size_t>(2) * size_ * pitch;
}

std::string OceanPeer::way_name(std::size_t way_index) const {
  const Way& way = ways_[way_index];
  return fmt::format("C++ and FFTW measure, {} OpenMP threads {}, pitch {}, {} maps", core_count(),
                     way.cores == Cores::share_transforms ? "share transforms" : "take one each", way.pitch,
                     way.stores == peer::Stores::streaming ? "streamed" : "cached");
}

void OceanPeer::evolve(const ocean::WaveTime& time, int row, int pitch) {
  const std::size_t plane = rate_.size(), first = static_cast<std::size_t>(row) * size_;
  const float* const p = amplitude_.data() + first;
  float* const spectra = spectra_.data();
  const auto row_floats = static_cast<std::size_t>(2) * pitch;
  peer::evolve({.size = size_,
                .wavenumber_step_radpm = wavenumber_step_radpm_,
                .choppiness = choppiness_,
                .ticks = time.ticks,
                .tick_fraction = time.tick_fraction},
               {.p_re = p,
                .p_im = p + plane,
                .q_re = p + 2 * plane,
                .q_im = p + 3 * plane,
                .rate = rate_.data() + first,
                .kz_radpm = static_cast<float>(row) * wavenumber_step_radpm_},
               spectra + row * row_floats, row > 0 ? spectra + (size_ - row) * row_floats : nullptr,
               field_floats(pitch));
  if (row > 0) return;
  // The row of Nyquist's wavenumber carries nothing.
  for (int field = 0; field < fields; ++field) {
    std::memset(spectra + field * field_floats(pitch) + size_ / 2 * row_floats, 0,
                row_floats * sizeof(float));
  }
}

void OceanPeer::pack(int row, const Way& way) {
  const std::size_t field = field_floats(way.pitch);
  const float* const source = spectra_.data() + static_cast<std::size_t>(2) * row * way.pitch;
  const std::size_t target = static_cast<std::size_t>(4) * row * size_;
  peer::pack(source, source + field, displacement_.data() + target, size_, way.stores);
  peer::pack(source + 2 * field, source + 3 * field, gradient_.data() + target, size_, way.stores);
}

void OceanPeer::at(const ocean::WaveTime& time, std::size_t way_index) {
  const Way& way = ways_[way_index];
#pragma omp parallel for schedule(static)
  for (int row = 0; row < size_ / 2; ++row) evolve(time, row, way.pitch);

  if (way.cores == Cores::share_transforms) {
    way.plan.execute();
  } else {
#pragma omp parallel for schedule(static, 1)
    for (int field = 0; field < fields; ++field) {
      float* const spectrum = spectra_.data() + field * field_floats(way.pitch);
      way.plan.execute(spectrum, spectrum);
    }
  }

#pragma omp parallel
  {
#pragma omp for schedule(static) nowait
    for (int row = 0; row < size_; ++row) pack(row, way);
    peer::finish_stores();
  }
}

}  // namespace offing::bench
