#include "host/ocl/glsl_source.h"

#include <map>
#include <sstream>

#include <fmt/format.h>

#include "host/ocl/program_source.h"

namespace offing::ocl {
namespace {

// GLSL numbers files where OpenCL C names them: `#line 7 "kernels/a.clh"` becomes `#line 7 1`.
class FileNumbers {
 public:
  std::string numbered(const std::string& line_directive) {
    const std::size_t quote = line_directive.find('"');
    const std::string name = line_directive.substr(quote + 1, line_directive.rfind('"') - quote - 1);
    const auto [entry, is_new] = numbers_.try_emplace(name, numbers_.size() + 1);
    if (is_new) legend_ += fmt::format("// file {}: {}\n", entry->second, name);
    return line_directive.substr(0, quote) + std::to_string(entry->second);
  }
  const std::string& legend() const { return legend_; }

 private:
  std::map<std::string, std::size_t> numbers_;
  std::string legend_;
};

// GLSL has no typedef: `typedef struct {` ... `} Name;` becomes `struct Name {` ... `};`.
void name_structs(std::string& text) {
  const std::string opening = "typedef struct {", closing = "\n} ";
  for (std::size_t at = text.find(opening); at != std::string::npos; at = text.find(opening, at)) {
    const std::size_t name_at = text.find(closing, at) + closing.size();
    const std::size_t name_end = text.find(';', name_at);
    const std::string name = text.substr(name_at, name_end - name_at);
    text.replace(name_at - 1, name_end - name_at + 1, "");
    text.replace(at, opening.size(), fmt::format("struct {} {{", name));
  }
}

}  // namespace

std::string glsl_source(std::string_view source_name) {
  FileNumbers files;
  std::string text;
  std::istringstream lines(assemble_source(source_name));
  for (std::string line; std::getline(lines, line);) {
    text += (line.starts_with("#line ") ? files.numbered(line) : line) + "\n";
  }
  name_structs(text);
  return files.legend() + text;
}

}  // namespace offing::ocl
