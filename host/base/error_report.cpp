#include "host/base/error_report.h"

#include <cstdio>

#include <fmt/format.h>

namespace offing {

void report(const Error& error) {
  // Not fmt::print(), which throws where stderr is full: there is nobody left to tell.
  std::string text = fmt::format("error: {}\n", one_line(error.what()));
  if (!error.hint().empty()) {
    text += fmt::format("hint: {}\n", one_line(error.hint()));
  }
  std::fputs(text.c_str(), stderr);
}

std::string one_line(std::string_view text) {
  std::string line;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7f) {
      line += fmt::format("\\x{:02x}", byte);
    } else {
      line += c;
    }
  }
  return line;
}

}  // namespace offing
