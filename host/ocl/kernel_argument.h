#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "host/ocl/opencl.h"

namespace offing::ocl {

/// One parameter of a kernel as its source declares it.
struct KernelArgument {
  enum class Kind { memory, local, value, unknown };
  enum class Number { integer, floating, unknown };

  Kind kind = Kind::unknown;  ///< unknown: the driver does not say, and checks alone
  std::string name;
  std::string type;                 ///< as the driver spells it, "float*"
  std::size_t bytes = 0;            ///< of a value; 0 for structs, whose size only the driver knows
  Number number = Number::unknown;  ///< of a scalar value
};

/// The parameters of `kernel`, in order. Drivers that built the program from a binary may not know them: then
/// all are of kind unknown.
std::vector<KernelArgument> kernel_arguments(cl_kernel kernel);

/// Size of an OpenCL C scalar or vector type ("float4" is 16, "uint3" 16); 0 for any other type.
std::size_t value_bytes(const std::string& type);

}  // namespace offing::ocl
