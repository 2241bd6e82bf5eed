// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#include "tests/bench/peers/fftw_plan.h"

#include <utility>

#include <fmt/format.h>
#include <omp.h>

#include "host/base/error.h"

namespace offing::bench {
namespace {

/// FFTW's parallel loop, run by OpenMP.
void openmp_loop(void* (*work)(char*), char* jobs, std::size_t job_bytes, int count, void*) {
#pragma omp parallel for schedule(static, 1) num_threads(count)
  for (int i = 0; i < count; ++i) work(jobs + static_cast<std::size_t>(i) * job_bytes);
}

void use_loop_of(Threading threading) {
  fftwf_threads_set_callback(threading == Threading::openmp ? openmp_loop : nullptr, nullptr);
}

fftwf_complex* as_complex(float* array) {
  return reinterpret_cast<fftwf_complex*>(array);
}

}  // namespace

std::string_view to_string(Threading threading) {
  switch (threading) {
    case Threading::one:
      return "1 thread";
    case Threading::posix:
      return "all cores, own threads";
    case Threading::openmp:
      return "all cores, OpenMP";
  }
  return {};
}

int core_count() {
  return omp_get_num_procs();
}

FftwPlan::FftwPlan(const Layout& layout, float* input, float* output, Threading threading)
    : threading_(threading) {
  static const int threads_are_ready = fftwf_init_threads();
  if (threads_are_ready == 0) {
    throw Error(ErrorKind::out_of_memory, "FFTW: its threads cannot be started",
                "raise the limit on threads (ulimit -u)");
  }
  use_loop_of(threading);
  fftwf_plan_with_nthreads(threading == Threading::one ? 1 : core_count());
  const int sizes[2] = {layout.size, layout.size};
  const int embedding[2] = {layout.size, layout.pitch};
  const int distance = layout.size * layout.pitch;
  plan_ = fftwf_plan_many_dft(2, sizes, layout.batch, as_complex(input), embedding, 1, distance,
                              as_complex(output), embedding, 1, distance, FFTW_BACKWARD, FFTW_MEASURE);
  if (plan_ == nullptr) {
    throw Error(
        ErrorKind::out_of_memory,
        fmt::format("FFTW: no plan for {} transforms of {} x {}", layout.batch, layout.size, layout.size),
        "choose a smaller size");
  }
}

FftwPlan::FftwPlan(FftwPlan&& other) noexcept
    : plan_(std::exchange(other.plan_, nullptr)), threading_(other.threading_) {}

FftwPlan::~FftwPlan() {
  if (plan_ != nullptr) fftwf_destroy_plan(plan_);
}

void FftwPlan::execute() const {
  use_loop_of(threading_);
  fftwf_execute(plan_);
}

void FftwPlan::execute(float* input, float* output) const {
  fftwf_execute_dft(plan_, as_complex(input), as_complex(output));
}

}  // namespace offing::bench
