#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <initializer_list>
#include <map>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <utility>

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <offing.h>

/// What the sources of offing._core share: calls of offing.h, handles, and arrays of numpy's.
namespace nb = nanobind;

/// A text as a str. Drivers and files give bytes that are not UTF-8, or texts that are cut within a letter.
inline nb::object str_of(const char* text) {
  return nb::steal(PyUnicode_DecodeUTF8(text, static_cast<Py_ssize_t>(std::strlen(text)), "replace"));
}

/// Raises the class of offing.errors that a status stands for.
[[noreturn]] inline void raise(OffingStatus status) {
  const nb::object make = nb::module_::import_("offing.errors").attr("from_status");
  const nb::object error =
      make(static_cast<int>(status), str_of(offing_last_error()), str_of(offing_last_hint()));
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

/// A call with progress for a Python callable, or None. False from the callable stops the call with
/// offing.Cancelled. An exception from it, or an interrupt by the keyboard, stops the call and is raised.
class Watched {
 public:
  explicit Watched(nb::object callable) : callable_(std::move(callable)) {
    progress_.size = sizeof progress_;
    progress_.callback = [](void* user, double share) {
      return static_cast<Watched*>(user)->stops_at(share);
    };
    progress_.user = this;
  }
  Watched(const Watched&) = delete;
  Watched& operator=(const Watched&) = delete;

  /// `call` gets the OffingProgress.
  template <class Call>
  void run(const Call& call) {
    OffingStatus status = OFFING_OK;
    {
      const nb::gil_scoped_release released;
      status = call(&progress_);
    }
    if (raised_) std::rethrow_exception(std::exchange(raised_, nullptr));
    if (status != OFFING_OK) raise(status);
  }

 private:
  int stops_at(double share) noexcept {
    const nb::gil_scoped_acquire acquired;
    try {
      if (PyErr_CheckSignals() != 0) throw nb::python_error();
      return !callable_.is_none() && callable_(share).is(nb::handle(Py_False)) ? 1 : 0;
    } catch (...) {
      raised_ = std::current_exception();
      return 1;
    }
  }

  nb::object callable_;
  OffingProgress progress_{};
  std::exception_ptr raised_;
};

/// A handle of offing.h and the call that frees it, without Python's lock: a thread that the call waits for
/// may write to the log, whose callback takes the lock.
template <class Handle, void (*free_handle)(Handle*)>
struct Free {
  void operator()(Handle* handle) const {
    const nb::gil_scoped_release released;
    free_handle(handle);
  }
};
template <class Handle, void (*free_handle)(Handle*)>
using Owned = std::unique_ptr<Handle, Free<Handle, free_handle>>;

/// Memory of arrays. What arrays that are gone had serves the next ones of the same size: new pages, which
/// the system clears, would take a third of the time of 100,000 samples. Use it with Python's lock.
class ArrayMemory {
 public:
  explicit ArrayMemory(std::size_t size)
      : size_(size), bytes_(std::make_unique_for_overwrite<std::byte[]>(size)) {}

  void* data() const { return bytes_.get(); }

  static ArrayMemory* take(std::size_t size) {
    Kept& kept = all_kept();
    const auto found = kept.memory.find(size);
    if (found == kept.memory.end()) return new ArrayMemory(size);
    ArrayMemory* const memory = found->second.release();
    kept.memory.erase(found);
    kept.bytes -= size;
    return memory;
  }
  static void give_back(ArrayMemory* gone) noexcept {
    constexpr std::size_t least_bytes = 1 << 16, most_bytes = 1 << 26;
    std::unique_ptr<ArrayMemory> memory(gone);
    Kept& kept = all_kept();
    if (gone->size_ < least_bytes || gone->size_ > most_bytes) return;
    if (kept.bytes + gone->size_ > most_bytes) kept = {};
    try {
      kept.memory.emplace(gone->size_, std::move(memory));
      kept.bytes += gone->size_;
    } catch (const std::bad_alloc&) {
    }
  }

 private:
  struct Kept {
    std::multimap<std::size_t, std::unique_ptr<ArrayMemory>> memory;
    std::size_t bytes = 0;
  };
  /// Lives to the end: arrays may go after everything else.
  static Kept& all_kept() {
    static Kept* const kept = new Kept;
    return *kept;
  }

  std::size_t size_;
  std::unique_ptr<std::byte[]> bytes_;
};

/// A new array of numpy's that owns its memory, not yet filled.
template <class Value>
nb::ndarray<nb::numpy, Value> new_array(std::initializer_list<std::size_t> shape) {
  std::size_t count = 1;
  for (const std::size_t length : shape) count *= length;
  ArrayMemory* const memory = ArrayMemory::take(count * sizeof(Value));
  const nb::capsule owner(
      memory, [](void* gone) noexcept { ArrayMemory::give_back(static_cast<ArrayMemory*>(gone)); });
  return {static_cast<Value*>(memory->data()), shape, owner};
}

inline nb::ndarray<nb::numpy, double> copied(const double* values, std::initializer_list<std::size_t> shape) {
  auto array = new_array<double>(shape);
  std::copy(values, values + array.size(), array.data());
  return array;
}

/// Length of a picture's side in its array. Sizes that offing.h refuses make an empty array, for the call to
/// refuse.
inline std::size_t picture_side(int length_px) {
  return length_px < 1 || length_px > 16384 ? 0 : static_cast<std::size_t>(length_px);
}

/// Points or directions [n, width] of the caller's, doubles.
template <std::size_t width>
using Rows = nb::ndarray<const double, nb::shape<-1, width>, nb::c_contig, nb::device::cpu>;

/// Adds the classes and functions of one source to the module.
void bind_mesh(nb::module_& module);
void bind_terrain(nb::module_& module);
void bind_world_parts(nb::module_& module);
