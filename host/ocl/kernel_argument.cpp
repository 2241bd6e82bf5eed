#include "host/ocl/kernel_argument.h"

#include <array>
#include <string_view>

#include "host/ocl/status.h"

namespace offing::ocl {
namespace {

struct ScalarType {
  std::string_view name;
  std::size_t bytes;
  KernelArgument::Number number;
};

// OpenCL C 1.2, table 6.1, and the long spellings that some drivers report.
constexpr auto integer = KernelArgument::Number::integer;
constexpr auto floating = KernelArgument::Number::floating;
constexpr std::array scalar_types{
    ScalarType{"char", 1, integer},          ScalarType{"uchar", 1, integer},
    ScalarType{"unsigned char", 1, integer}, ScalarType{"short", 2, integer},
    ScalarType{"ushort", 2, integer},        ScalarType{"unsigned short", 2, integer},
    ScalarType{"int", 4, integer},           ScalarType{"uint", 4, integer},
    ScalarType{"unsigned int", 4, integer},  ScalarType{"long", 8, integer},
    ScalarType{"ulong", 8, integer},         ScalarType{"unsigned long", 8, integer},
    ScalarType{"half", 2, floating},         ScalarType{"float", 4, floating},
    ScalarType{"double", 8, floating},
};

const ScalarType* scalar_type(std::string_view name) {
  for (const ScalarType& type : scalar_types) {
    if (type.name == name) return &type;
  }
  return nullptr;
}

std::string argument_text(cl_kernel kernel, cl_uint index, cl_kernel_arg_info what) {
  std::size_t bytes = 0;
  if (clGetKernelArgInfo(kernel, index, what, 0, nullptr, &bytes) != CL_SUCCESS || bytes == 0) return {};
  std::string text(bytes, '\0');
  if (clGetKernelArgInfo(kernel, index, what, bytes, text.data(), nullptr) != CL_SUCCESS) return {};
  return text.substr(0, text.find('\0'));
}

KernelArgument kernel_argument(cl_kernel kernel, cl_uint index) {
  KernelArgument argument;
  cl_kernel_arg_address_qualifier address = 0;
  if (clGetKernelArgInfo(kernel, index, CL_KERNEL_ARG_ADDRESS_QUALIFIER, sizeof address, &address, nullptr) !=
      CL_SUCCESS) {
    return argument;
  }
  argument.name = argument_text(kernel, index, CL_KERNEL_ARG_NAME);
  argument.type = argument_text(kernel, index, CL_KERNEL_ARG_TYPE_NAME);
  switch (address) {
    case CL_KERNEL_ARG_ADDRESS_GLOBAL:
    case CL_KERNEL_ARG_ADDRESS_CONSTANT:
      argument.kind = KernelArgument::Kind::memory;
      break;
    case CL_KERNEL_ARG_ADDRESS_LOCAL:
      argument.kind = KernelArgument::Kind::local;
      break;
    default:
      argument.kind = KernelArgument::Kind::value;
      argument.bytes = value_bytes(argument.type);
      if (const ScalarType* scalar = scalar_type(argument.type)) argument.number = scalar->number;
  }
  return argument;
}

}  // namespace

std::size_t value_bytes(const std::string& type) {
  if (const ScalarType* scalar = scalar_type(type)) return scalar->bytes;
  const std::size_t digits = type.find_first_of("0123456789");
  if (digits == std::string::npos) return 0;
  const ScalarType* element = scalar_type(std::string_view(type).substr(0, digits));
  const std::string_view lanes = std::string_view(type).substr(digits);
  if (element == nullptr) return 0;
  if (lanes == "2") return 2 * element->bytes;
  if (lanes == "3" || lanes == "4") return 4 * element->bytes;  // a vector of 3 is stored as one of 4
  if (lanes == "8") return 8 * element->bytes;
  if (lanes == "16") return 16 * element->bytes;
  return 0;
}

std::vector<KernelArgument> kernel_arguments(cl_kernel kernel) {
  cl_uint count = 0;
  check(clGetKernelInfo(kernel, CL_KERNEL_NUM_ARGS, sizeof count, &count, nullptr), "clGetKernelInfo",
        "a kernel");
  std::vector<KernelArgument> arguments;
  for (cl_uint index = 0; index < count; ++index) arguments.push_back(kernel_argument(kernel, index));
  return arguments;
}

}  // namespace offing::ocl
