// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#include <random>

#include "host/fft/fft2d.h"
#include "tests/bench/benches.h"
#include "tests/bench/difference.h"
#include "tests/bench/huge_array.h"
#include "tests/bench/peers/fftw_plan.h"

namespace offing::bench {
namespace {

constexpr int smallest_single_size = 256;  // smaller ones come in batches
constexpr int batch_of_small_sizes = 16;   // four fields of four cascades

std::vector<float> random_values(std::size_t count) {
  std::mt19937 generator(20240521u);
  std::uniform_real_distribution<float> uniform(-1.0f, 1.0f);
  std::vector<float> values(count);
  for (float& value : values) value = uniform(generator);
  return values;
}

/// One of the ways to call FFTW.
struct FftwWay {
  FftwPlan plan;
  bool uses_openmp;
  float* result;
  std::string name;
};

std::vector<FftwWay> plan_all_ways(int size, int batch, HugeArray& input, HugeArray& output) {
  std::vector<FftwWay> ways;
  for (const Threading threading : {Threading::one, Threading::posix, Threading::openmp}) {
    if (threading != Threading::one && core_count() == 1) continue;
    for (HugeArray* target : {&output, &input}) {
      ways.push_back(
          {FftwPlan({.size = size, .batch = batch, .pitch = size}, input.data(), target->data(), threading),
           threading == Threading::openmp, target->data(),
           fmt::format("FFTW measure, {}, {}", to_string(threading),
                       target == &output ? "out of place" : "in place")});
    }
  }
  return ways;
}

void bench_size(const ocl::Device& device, int size, int blocks, const Sinks& sinks) {
  const int batch = size < smallest_single_size ? batch_of_small_sizes : 1;
  fft::Fft2d ours(device, size, batch, fft::Direction::inverse);
  const std::vector<float> values = random_values(ours.float_count());
  const ocl::Buffer<float> ours_input(device, values, "benchmark input");
  ocl::Buffer<float> ours_output(device, values.size(), "benchmark output");
  const Work enqueue_ours = [&] { ours.transform(ours_input, ours_output); };
  const auto until_finished = [&](Work work) -> Work {
    return [&device, work] {
      work();
      device.finish();
    };
  };
  enqueue_ours();
  const std::vector<float> ours_result = ours_output.read();

  sinks.note(fmt::format("fft {}: planning FFTW", size));
  HugeArray input(values.size()), output(values.size());
  std::vector<FftwWay> ways = plan_all_ways(size, batch, input, output);
  std::vector<Work> peers;
  for (const FftwWay& way : ways) {
    std::copy(values.begin(), values.end(), input.data());
    way.plan.execute();
    require_equal(fmt::format("fft {}, {}", size, way.name), ours_result.data(), way.result, values.size());
    peers.emplace_back([&way] { way.plan.execute(); });
  }
  // In place again and again, values would grow without bound; zeros take the same time.
  input.clear();
  output.clear();
  const std::string name = batch == 1 ? "fft" : fmt::format("fft_batch{}", batch);
  for (const bool uses_openmp : {false, true}) {
    std::vector<std::size_t> candidates;
    std::vector<Work> alternatives;
    for (std::size_t way = 0; way < ways.size(); ++way) {
      if (ways[way].uses_openmp != uses_openmp) continue;
      candidates.push_back(way);
      alternatives.push_back(peers[way]);
    }
    if (candidates.empty()) continue;  // one core: no threads to share
    const std::size_t best = candidates[fastest(alternatives)];
    sinks.row(
        row_of(name, size, ways[best].name,
               for_each_one(compare(until_finished(repeated(enqueue_ours)), repeated(peers[best]), blocks))));
    sinks.row(row_of(name + "_alone", size, ways[best].name,
                     compare(until_finished(enqueue_ours), peers[best], blocks)));
  }
}

}  // namespace

void bench_fft(const ocl::Device& device, const Settings& settings, const Sinks& sinks) {
  for (const int size : settings.sizes) bench_size(device, size, settings.blocks, sinks);
}

}  // namespace offing::bench
