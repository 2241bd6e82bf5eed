#include "host/ocl/program_source.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
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

}  // namespace

std::string assemble_source(std::string_view source_name) {
  Assembler assembler;
  assembler.add(source_name, "Program::build");
  return assembler.take();
}

std::vector<std::string> replaced_files(std::string_view source_name) {
  Assembler assembler;
  assembler.add(source_name, "replaced_files");
  return assembler.take_replaced();
}

}  // namespace offing::ocl
