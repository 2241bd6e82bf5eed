#include "host/base/error.h"

#include <cstdio>
#include <utility>

#include <fmt/format.h>

namespace offing {
namespace {

/// Control bytes and those above `highest` as \xNN.
std::string escaped(std::string_view text, unsigned char highest) {
  std::string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7f || byte > highest) {
      out += fmt::format("\\x{:02x}", byte);
    } else {
      out += c;
    }
  }
  return out;
}

std::string lines_of(const Error& error) {
  const std::string hint = error.hint().empty() ? "" : fmt::format("hint: {}\n", one_line(error.hint()));
  return fmt::format("error: {}\n{}", one_line(error.what()), hint);
}

}  // namespace

Error::Error(ErrorKind kind, const std::string& what, std::string hint)
    : std::runtime_error(what), kind_(kind), hint_(std::move(hint)) {}

int exit_code(ErrorKind kind) noexcept {
  switch (kind) {
    case ErrorKind::bad_usage:
    case ErrorKind::bad_input:
      return 2;
    case ErrorKind::no_device:
      return 3;
    case ErrorKind::cancelled:
      return 130;  // 128 + SIGINT, as shells report it
    default:
      return 1;
  }
}

void report(const Error& error) {
  std::string text;
  if (const auto* list = dynamic_cast<const ErrorList*>(&error)) {
    for (const Error& each : list->errors()) text += lines_of(each);
  } else {
    text = lines_of(error);
  }
  // Not fmt::print(), which throws where stderr is full: there is nobody left to tell.
  std::fputs(text.c_str(), stderr);
}

std::string one_line(std::string_view text) {
  return escaped(text, 0xff);
}

std::string printable(std::string_view text) {
  constexpr std::size_t most = 60;
  return escaped(text.substr(0, most), 0x7f) + (text.size() > most ? "..." : "");
}

}  // namespace offing
