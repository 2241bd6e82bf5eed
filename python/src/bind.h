#pragma once

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <offing.h>

/// What the sources of offing._core share: calls of offing.h, handles, and arrays of numpy's.
namespace nb = nanobind;

/// Raises the class of offing.errors that a status stands for.
[[noreturn]] inline void raise(OffingStatus status) {
  const nb::object make = nb::module_::import_("offing.errors").attr("from_status");
  const nb::object error = make(static_cast<int>(status), offing_last_error(), offing_last_hint());
  PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(error.ptr())), error.ptr());
  throw nb::python_error();
}

/// Runs a call of offing.h without Python's lock.
template <class Call>
void run(const Call& call) {
  OffingStatus status = OFFING_OK;
  {
    const nb::gil_scoped_release released;
    status = call();
  }
  if (status != OFFING_OK) raise(status);
}

/// A handle of offing.h and the call that frees it.
template <class Handle, void (*free_handle)(Handle*)>
struct Free {
  void operator()(Handle* handle) const { free_handle(handle); }
};
template <class Handle, void (*free_handle)(Handle*)>
using Owned = std::unique_ptr<Handle, Free<Handle, free_handle>>;

/// A new array of numpy's that owns its memory, not yet filled.
template <class Value>
nb::ndarray<nb::numpy, Value> new_array(std::initializer_list<std::size_t> shape) {
  std::size_t count = 1;
  for (const std::size_t length : shape) count *= length;
  auto memory = std::make_unique_for_overwrite<Value[]>(count);
  Value* const data = memory.get();
  const nb::capsule owner(memory.release(),
                          [](void* values) noexcept { delete[] static_cast<Value*>(values); });
  return {data, shape, owner};
}

inline nb::ndarray<nb::numpy, double> copied(const double* values, std::initializer_list<std::size_t> shape) {
  auto array = new_array<double>(shape);
  std::copy(values, values + array.size(), array.data());
  return array;
}

/// Points or directions [n, width] of the caller's, doubles.
template <std::size_t width>
using Rows = nb::ndarray<const double, nb::shape<-1, width>, nb::c_contig, nb::device::cpu>;

/// Adds the classes and functions of one source to the module.
void bind_mesh(nb::module_& module);
void bind_terrain(nb::module_& module);
void bind_world_parts(nb::module_& module);
