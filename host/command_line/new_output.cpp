#include "host/command_line/new_output.h"

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/error_report.h"
#include "host/io/file_presence.h"

namespace offing {

void require_new(const std::string& output, Overwriting overwriting) {
  if (output.empty() || overwriting == Overwriting::allowed || !is_there(output)) return;
  throw Error(ErrorKind::file, fmt::format("{}: is there already", one_line(output)),
              "--force replaces it, or name another file");
}

}  // namespace offing
