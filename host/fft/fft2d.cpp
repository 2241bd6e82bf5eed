#include "host/fft/fft2d.h"

#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <vector>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/fft/sound_family.h"
#include "host/ocl/program.h"

namespace offing::fft {
namespace {

using Complex = std::complex<double>;

PlanRequest request_of(int size) {
  return {.size = size, .columns = size, .result_fields = 1};
}

// Columns, then rows.
std::vector<ocl::ProgramRecipe> programs_of(const FftPlan& plan, Direction direction) {
  std::vector<ocl::ProgramRecipe> programs{{"fft/transform_columns.cl", plan.columns().defines},
                                           {"fft/transform_rows.cl", plan.rows().defines}};
  for (ocl::ProgramRecipe& program : programs) {
    if (direction == Direction::forward) program.defines.set_flag("FFT_FORWARD");
  }
  return programs;
}

// Random values a[j], and their transform A[k] = sum a[j] e^{+-2 pi i j k / n}, in double precision.
struct Line {
  Line(int size, Direction direction, unsigned seed) : values(static_cast<std::size_t>(size)) {
    std::mt19937 random(seed);
    const auto next = [&random] { return static_cast<double>(random()) * 0x1p-31 - 1.0; };
    for (Complex& value : values) value = {next(), next()};
    const std::size_t n = values.size();
    const double sign = direction == Direction::forward ? -1.0 : 1.0;
    std::vector<Complex> roots(n);
    for (std::size_t j = 0; j < n; ++j)
      roots[j] = std::polar(1.0, sign * 2.0 * std::numbers::pi * static_cast<double>(j) / size);
    transform.assign(n, 0.0);
    for (std::size_t k = 0; k < n; ++k) {
      for (std::size_t j = 0; j < n; ++j) transform[k] += values[j] * roots[j * k % n];
    }
  }
  std::vector<Complex> values, transform;
};

// The transform of a[z] b[x] is A[z] B[x]: a reference for values everywhere that takes n^2 operations.
double self_test_error(const ocl::Device& device, Fft2d& fft, Direction direction) {
  const Line rows(fft.size(), direction, 1), columns(fft.size(), direction, 2);
  std::vector<float> values;
  values.reserve(fft.float_count());
  for (const Complex& a : rows.values) {
    for (const Complex& b : columns.values) {
      const Complex value = a * b;
      values.push_back(static_cast<float>(value.real()));
      values.push_back(static_cast<float>(value.imag()));
    }
  }
  ocl::Buffer<float> buffer(device, values, "self-test of a transform");
  fft.transform(buffer, buffer);
  buffer.read(values);
  double error = 0.0, norm = 0.0;
  std::size_t place = 0;
  for (const Complex& a : rows.transform) {
    for (const Complex& b : columns.transform) {
      const Complex expected = a * b, found{values[place], values[place + 1]};
      error += std::norm(found - expected);
      norm += std::norm(expected);
      place += 2;
    }
  }
  return std::sqrt(error / norm);
}

}  // namespace

ocl::KernelShape Fft2d::family_for(const ocl::Device& device, int size, Direction direction) {
  const PlanRequest request = request_of(size);
  return sound_family(device, request,
                      {.programs =
                           [&](ocl::KernelShape family) {
                             return programs_of(FftPlan(device.info(), request, family), direction);
                           },
                       .error_of =
                           [&](ocl::KernelShape family) {
                             Fft2d one(device, size, 1, direction, family);
                             return self_test_error(device, one, direction);
                           }});
}

Fft2d::Fft2d(const ocl::Device& device, int size, int batch, Direction direction)
    : Fft2d(device, size, batch, direction, family_for(device, size, direction)) {}

Fft2d::Fft2d(const ocl::Device& device, int size, int batch, Direction direction, ocl::KernelShape family)
    : size_(size), batch_(batch) {
  if (batch < 1) {
    throw Error(ErrorKind::bad_input, fmt::format("transform batch: expected at least 1, got {}", batch),
                "ask for one transform or more");
  }
  const FftPlan plan(device.info(), request_of(size), family);
  const std::vector<ocl::ProgramRecipe> programs = programs_of(plan, direction);
  const auto kernel_of = [&device](const ocl::ProgramRecipe& program, const char* name) {
    return ocl::Program::build(device, program.source_name, program.defines).kernel(name);
  };
  columns_ = kernel_of(programs[0], "transform_columns");
  rows_ = kernel_of(programs[1], "transform_rows");
  columns_shape_ = plan.columns().shape_for(batch);
  columns_scratch_ = {plan.columns().scratch_bytes};
  rows_shape_ = plan.rows().shape_for(batch);
  row_twiddles_ = ocl::Buffer<float>(device, plan.rows().twiddles, "row twiddles");
  column_twiddles_ = ocl::Buffer<float>(device, plan.columns().twiddles, "column twiddles");
  intermediate_ = ocl::Buffer<float>(device, plan.intermediate_floats() * static_cast<std::size_t>(batch),
                                     "transform intermediate");
}

std::size_t Fft2d::float_count() const {
  return static_cast<std::size_t>(batch_) * static_cast<std::size_t>(size_) *
         static_cast<std::size_t>(size_) * 2;
}

void Fft2d::transform(const ocl::Buffer<float>& input, ocl::Buffer<float>& output) {
  if (input.size() < float_count() || output.size() < float_count()) {
    throw Error(ErrorKind::bad_input,
                fmt::format("transform buffers: expected at least {} floats, got {} and {}", float_count(),
                            input.size(), output.size()),
                "make both buffers of float_count() floats");
  }
  columns_.launch(columns_shape_, input, intermediate_, column_twiddles_, columns_scratch_);
  rows_.launch(rows_shape_, intermediate_, row_twiddles_, output);
}

}  // namespace offing::fft
