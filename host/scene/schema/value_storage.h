// Where values lie in the struct of their section: typed where a row is written, erased in the table, so that
// code that walks the table is compiled once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <glm/vec3.hpp>

#include "host/base/utc_time.h"

namespace offing::scene {

/// A value at some distance from the start of its section's struct.
template <class Value>
class ValueAt {
 public:
  ValueAt() = default;
  explicit ValueAt(std::size_t offset) : offset_(offset) {}

  std::size_t offset() const { return offset_; }
  const Value& in(const void* section) const {
    const void* value = static_cast<const std::byte*>(section) + offset_;
    return *static_cast<const Value*>(value);
  }
  Value& in(void* section) const {
    void* value = static_cast<std::byte*>(section) + offset_;
    return *static_cast<Value*>(value);
  }

 private:
  std::size_t offset_ = 0;
};

/// One of several named values.
struct ChoiceStorage {
  std::vector<std::string_view> names;
  std::size_t offset = 0;
  /// The index of a value's name.
  std::size_t (*get)(const void* value) = nullptr;
  void (*set)(void* value, std::size_t index) = nullptr;

  std::size_t in(const void* section) const { return get(static_cast<const std::byte*>(section) + offset); }
  void set_in(void* section, std::size_t index) const {
    set(static_cast<std::byte*>(section) + offset, index);
  }
};

/// Where a row's value lies; the alternative is its type. Triples are written as lists.
using Storage =
    std::variant<ValueAt<double>, ValueAt<std::optional<double>>, ValueAt<int>, ValueAt<std::uint64_t>,
                 ValueAt<std::string>, ValueAt<std::optional<UtcTime>>, ValueAt<std::vector<double>>,
                 ValueAt<glm::dvec3>, ValueAt<std::optional<glm::dvec3>>, ChoiceStorage>;

/// The same value, in a struct that holds the section's struct at this offset.
Storage moved(Storage storage, std::size_t offset);

/// A member, or a member of a member, of a struct.
template <class Struct, class Value>
struct Path {
  std::size_t offset;
};

template <class Struct, class Value>
Path<Struct, Value> path(Value Struct::*member) {
  static const Struct example{};
  const void* start = &example;
  const void* value = &(example.*member);
  return {
      static_cast<std::size_t>(static_cast<const std::byte*>(value) - static_cast<const std::byte*>(start))};
}

/// `path(&Outer::inner, &Inner::value)`: runtime pointers, which compile five times as fast as template
/// arguments do.
template <class Struct, class Middle, class Inner, class Value>
Path<Struct, Value> joined(Path<Struct, Middle> first, Path<Inner, Value> rest) {
  static_assert(std::is_base_of_v<Inner, Middle>);
  return {first.offset + rest.offset};
}

template <class Struct, class Middle, class... Rest>
auto path(Middle Struct::*first, Rest... rest) {
  return joined(path(first), path(rest...));
}

/// Where a row of Schema<Struct> has its value.
template <class Struct>
struct Where {
  Storage storage;

  // Implicit: rows begin with a member pointer or a path.
  template <class Value>
  Where(Value Struct::*member) : Where(path(member)) {}  // NOLINT(google-explicit-constructor)
  template <class Value>
  // NOLINTNEXTLINE(google-explicit-constructor)
  Where(Path<Struct, Value> at) : storage(ValueAt<Value>(at.offset)) {}
  explicit Where(ChoiceStorage choice) : storage(std::move(choice)) {}
};

/// An enumeration, or an index, whose values count from 0 in the order of their names.
template <class Struct, class Enum>
Where<Struct> choice(Path<Struct, Enum> at, std::vector<std::string_view> names) {
  return Where<Struct>(ChoiceStorage{
      .names = std::move(names),
      .offset = at.offset,
      .get = [](const void* value) { return static_cast<std::size_t>(*static_cast<const Enum*>(value)); },
      .set = [](void* value, std::size_t index) { *static_cast<Enum*>(value) = static_cast<Enum>(index); }});
}

template <class Struct, class Enum>
Where<Struct> choice(Enum Struct::*member, std::vector<std::string_view> names) {
  return choice(path(member), std::move(names));
}

/// One that may be absent, which has a name too: the first.
template <class Struct, class Enum>
Where<Struct> choice_or(std::string_view absent, Path<Struct, std::optional<Enum>> at,
                        std::vector<std::string_view> names) {
  using Value = std::optional<Enum>;
  names.insert(names.begin(), absent);
  return Where<Struct>(ChoiceStorage{.names = std::move(names),
                                     .offset = at.offset,
                                     .get =
                                         [](const void* value) {
                                           const Value& chosen = *static_cast<const Value*>(value);
                                           return chosen ? static_cast<std::size_t>(*chosen) + 1 : 0;
                                         },
                                     .set =
                                         [](void* value, std::size_t index) {
                                           *static_cast<Value*>(value) =
                                               index == 0 ? Value{} : Value{static_cast<Enum>(index - 1)};
                                         }});
}

template <class Struct, class Enum>
Where<Struct> choice_or(std::string_view absent, std::optional<Enum> Struct::*member,
                        std::vector<std::string_view> names) {
  return choice_or(absent, path(member), std::move(names));
}

}  // namespace offing::scene
