// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "host/base/error.h"
#include "host/ocean/spectrum/spectrum_parameters.h"
#include "host/ocean/surface/cascades.h"
#include "host/ocean/surface/ocean.h"
#include "tests/bench/benches.h"

namespace offing::bench {
namespace {

namespace fs = std::filesystem;

constexpr int size = 256;
constexpr int cold_starts = 3;  // each compiles for seconds
constexpr double limit_ms = 300.0;

/// A folder for this life, with everything that comes to lie in it.
class ScratchFolder {
 public:
  ScratchFolder() : path_((fs::temp_directory_path() / "offing-bench-XXXXXX").string()) {
    if (mkdtemp(path_.data()) == nullptr) {
      throw Error(ErrorKind::file, fmt::format("{}: {}", path_, std::strerror(errno)),
                  "set TMPDIR to a folder that can be written");
    }
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

std::vector<std::string> environment_with_cache(const std::string& folder) {
  std::vector<std::string> variables{"OFFING_CACHE_DIR=" + folder + "/offing",
                                     "POCL_CACHE_DIR=" + folder + "/pocl"};
  for (char** variable = environ; *variable != nullptr; ++variable) {
    const std::string_view text = *variable;
    if (!text.starts_with("OFFING_CACHE_DIR=") && !text.starts_with("POCL_CACHE_DIR=")) {
      variables.emplace_back(text);
    }
  }
  return variables;
}

std::vector<char*> pointers_to(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  pointers.reserve(texts.size() + 1);
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

/// From just before the process is started until it says that its frame is there.
double start_ms(const std::string& device, const std::string& cache_folder) {
  std::vector<std::string> arguments{"offing-bench", "first-frame", "--device", device};
  std::vector<std::string> variables = environment_with_cache(cache_folder);
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0)
    throw Error(ErrorKind::file, "start-up: no pipe to the new process",
                "raise the limit on open files (ulimit -n)");
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  const auto start = std::chrono::steady_clock::now();
  pid_t process = -1;
  const int error = posix_spawn(&process, "/proc/self/exe", &actions, nullptr, pointers_to(arguments).data(),
                                pointers_to(variables).data());
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  char said = 0;
  const bool is_done = error == 0 && read(ends[0], &said, 1) == 1;
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
  close(ends[0]);
  int status = 0;
  if (error == 0) waitpid(process, &status, 0);
  if (!is_done || status != 0) {
    throw Error(ErrorKind::device, "start-up: the new process made no frame", "see its message above");
  }
  return time.count();
}

}  // namespace

void bench_start(const Settings& settings, const Sinks& sinks) {
  if (std::find(settings.sizes.begin(), settings.sizes.end(), size) == settings.sizes.end()) return;
  std::vector<double> cold_ms, warm_ms, ratios;
  for (int i = 0; i < cold_starts; ++i) {
    sinks.note(fmt::format("cold_start {}: compiling kernels, {} of {}", size, i + 1, cold_starts));
    cold_ms.push_back(start_ms(settings.device, ScratchFolder().path()));
  }
  sinks.row({.name = "cold_start",
             .size = size,
             .ours_ms = median(cold_ms),
             .peer = "none",
             .spread = relative_spread(cold_ms)});

  const ScratchFolder cache;
  start_ms(settings.device, cache.path());
  for (int i = 0; i < settings.blocks; ++i) {
    warm_ms.push_back(start_ms(settings.device, cache.path()));
    ratios.push_back(limit_ms / warm_ms.back());
  }
  sinks.row({.name = "warm_start",
             .size = size,
             .ours_ms = median(warm_ms),
             .peer = "limit of 0.3 s",
             .peer_ms = limit_ms,
             .ratio = median(ratios),
             .ratio_low = median_lower_bound(ratios),
             .spread = relative_spread(ratios)});
}

void make_first_frame(const std::string& selector) {
  const ocl::Device device = ocl::Device::open(selector);
  const ocean::SeaSpectrum spectrum = ocean::make_sea_spectrum({});
  ocean::OceanParameters parameters;
  parameters.size = size;
  parameters.cascades = ocean::choose_cascades(spectrum, size);
  ocean::Ocean ocean(device, spectrum, parameters);
  ocean.at(0.0);
  device.finish();
  fmt::print("frame\n");
  std::fflush(stdout);
}

}  // namespace offing::bench
