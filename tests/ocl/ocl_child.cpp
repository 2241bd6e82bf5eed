// What a test runs in a process of its own: ocl_child devices | build SOURCE KERNEL | memory BYTES.
// Ends with the exit code of the error it met, after printing it.

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include <sys/resource.h>

#include "host/base/error.h"
#include "host/ocl/buffer.h"
#include "host/ocl/program.h"

namespace {

using namespace offing;

// Opens the default device and prints its name.
void print_device() {
  std::puts(ocl::Device::open().info().name.c_str());
}

// Runs a kernel(global int*) on four zeros and prints the first result.
void build(const char* source, const char* kernel) {
  const ocl::Device device = ocl::Device::open();
  ocl::Buffer<int> values(device, 4, "values");
  values.fill(0);
  ocl::Program::build(device, source).kernel(kernel).launch({{4}}, values);
  std::printf("%d\n", values.read()[0]);
}

// Asks for a buffer of that size in a process that may only grow by half of it.
void exceed_memory(std::size_t bytes) {
  const ocl::Device device = ocl::Device::open();
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  const rlim_t limit = pages * 4096 + bytes / 2;
  const rlimit limits{limit, limit};
  setrlimit(RLIMIT_AS, &limits);
  const ocl::Buffer<char> buffer(device, bytes, "too large");
}

}  // namespace

int main(int argc, char** argv) {
  const std::string task = argc > 1 ? argv[1] : "";
  try {
    if (task == "devices") print_device();
    if (task == "build") build(argv[2], argv[3]);
    if (task == "memory") exceed_memory(std::strtoull(argv[2], nullptr, 10));
  } catch (const Error& error) {
    std::printf("error: %s\nhint: %s\n", error.what(), error.hint().c_str());
    return exit_code(error.kind());
  }
}
