#include "present/window/scene_sources.h"

#include <algorithm>

#include <fmt/format.h>

#include "host/base/error.h"

namespace offing::present {

const EmbeddedFile& shipped_source(std::string_view name) {
  const std::span<const EmbeddedFile> all = scene_sources();
  const auto found = std::ranges::find(all, name, &EmbeddedFile::name);
  if (found != all.end()) return *found;
  throw Error(ErrorKind::bad_input, fmt::format("{}: expected a scene that comes with Offing", name),
              "the window's list has their names");
}

}  // namespace offing::present
