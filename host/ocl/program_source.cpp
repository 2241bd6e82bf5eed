#include "host/ocl/program_source.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <utility>

#include <fmt/format.h>

#include "host/base/error.h"
#include "kernels/kernel_sources.h"

namespace offing::ocl {
namespace {

struct SourceFile {
  std::string label;  // what compiler messages call it
  std::string text;
};

std::optional<SourceFile> read_from_folder(std::string_view name) {
  const char* folder = std::getenv("OFFING_KERNEL_PATH");
  if (folder == nullptr || *folder == '\0') return std::nullopt;
  std::error_code error;
  if (!std::filesystem::is_directory(folder, error)) {
    throw Error(ErrorKind::bad_usage, fmt::format("OFFING_KERNEL_PATH: expected a folder, got {}", folder),
                "name the kernels/ folder of a checkout, or unset it");
  }
  const std::filesystem::path path = std::filesystem::path(folder) / name;
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  std::ostringstream text;
  text << file.rdbuf();
  return SourceFile{path.string(), text.str()};
}

std::optional<SourceFile> read_embedded(std::string_view name) {
  for (const kernels::KernelSource& source : kernels::kernel_sources()) {
    if (source.name == name) return SourceFile{fmt::format("kernels/{}", name), std::string(source.text)};
  }
  return std::nullopt;
}

// The path in `#include "path"`, empty for any other line.
std::string_view included_name(std::string_view line) {
  const auto skip_blanks = [&line] {
    const std::size_t first = line.find_first_not_of(" \t");
    line.remove_prefix(first == std::string_view::npos ? line.size() : first);
  };
  const auto skip = [&line](std::string_view word) {
    const bool is_next = line.starts_with(word);
    if (is_next) line.remove_prefix(word.size());
    return is_next;
  };
  skip_blanks();
  if (!skip("#")) return {};
  skip_blanks();
  if (!skip("include")) return {};
  skip_blanks();
  if (!skip("\"")) return {};
  skip("kernels/");
  return line.substr(0, line.find('"'));
}

class Assembler {
 public:
  void add(std::string_view name, const std::string& included_at) {
    if (!seen_.insert(std::string(name)).second) return;
    const std::optional<SourceFile> embedded = read_embedded(name);
    std::optional<SourceFile> file = read_from_folder(name);
    if (file && embedded && file->text != embedded->text) replaced_.emplace_back(name);
    if (!file) file = embedded;
    if (!file) {
      throw Error(
          ErrorKind::build_failed,
          fmt::format("{}: no kernel source \"{}\": expected a file below kernels/", included_at, name),
          "correct the name, or the folder in OFFING_KERNEL_PATH");
    }
    text_ += fmt::format("#line 1 \"{}\"\n", file->label);
    std::istringstream lines(file->text);
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
      ++number;
      const std::string_view included = included_name(line);
      if (included.empty()) {
        text_ += line + "\n";
        continue;
      }
      add(included, fmt::format("{}:{}", file->label, number));
      text_ += fmt::format("#line {} \"{}\"\n", number + 1, file->label);
    }
  }

  std::string take() { return std::move(text_); }
  std::vector<std::string> take_replaced() { return std::move(replaced_); }

 private:
  std::string text_;
  std::vector<std::string> replaced_;
  std::set<std::string> seen_;
};

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

std::string assemble_source(std::string_view source_name) {
  Assembler assembler;
  assembler.add(source_name, "Program::build");
  return assembler.take();
}

std::string at_true_line(std::string_view source, const std::string& message) {
  static const std::regex position("^([^:]+):([0-9]{1,9}):");
  std::smatch found;
  if (!std::regex_search(message, found, position)) return message;
  const int wanted = std::stoi(found[2]);
  std::istringstream lines{std::string(source)};
  std::string line, label;
  int number = 0;  // of the next line in its file
  for (int at = 1; std::getline(lines, line); ++at) {
    std::smatch directive;
    static const std::regex line_directive("^#line ([0-9]+) \"(.*)\"$");
    if (std::regex_match(line, directive, line_directive)) {
      number = std::stoi(directive[1]);
      label = directive[2];
      if (label == found[1]) return message;  // the driver has read the directives
    } else if (at == wanted && !label.empty()) {
      return fmt::format("{}:{}:{}", label, number, found.suffix().str());
    } else {
      ++number;
    }
  }
  return message;
}

std::vector<std::string> replaced_files(std::string_view source_name) {
  Assembler assembler;
  assembler.add(source_name, "replaced_files");
  return assembler.take_replaced();
}

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
