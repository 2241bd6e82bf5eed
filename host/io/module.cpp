#include "host/io/module.h"

#include <cstdlib>
#include <optional>
#include <system_error>

#include <dlfcn.h>
#include <fmt/format.h>
#include <link.h>

#include "host/base/error.h"

namespace offing {
namespace {

namespace fs = std::filesystem;

// The file of the program or shared library that this code is in.
fs::path own_file() {
  Dl_info info{};
  link_map* object = nullptr;
  std::error_code ignored;
  if (dladdr1(reinterpret_cast<const void*>(&module_folder), &info, reinterpret_cast<void**>(&object),
              RTLD_DL_LINKMAP) != 0 &&
      object != nullptr && object->l_name != nullptr && *object->l_name != '\0') {
    return fs::weakly_canonical(object->l_name, ignored);
  }
  return fs::read_symlink("/proc/self/exe", ignored);
}

std::string last_complaint() {
  const char* text = dlerror();
  return text == nullptr ? "no reason given" : one_line(text);
}

}  // namespace

std::string_view module_build() {
  return OFFING_BUILD;
}

fs::path module_folder() {
  if (const char* own = std::getenv("OFFING_MODULE_PATH"); own != nullptr && *own != '\0') return own;
  const fs::path beside = own_file().parent_path();
  for (const fs::path& folder : {beside / "offing", beside / OFFING_LIBRARIES_FROM_PROGRAMS / "offing",
                                 fs::path(OFFING_LIBRARY_FOLDER) / "offing"}) {
    std::error_code ignored;
    if (fs::is_directory(folder, ignored)) return folder.lexically_normal();
  }
  return {};
}

const void* module_table(std::string_view name, std::string_view purpose) {
  const fs::path file = module_folder() / fmt::format("{}.so", name);
  const auto fail = [&](std::string_view reason, const char* hint) -> Error {
    return {ErrorKind::file, fmt::format("cannot {}: {}: {}", purpose, one_line(file.string()), reason),
            hint};
  };
  // For a name without a folder, dlopen() would search the system's folders.
  if (!file.has_parent_path()) {
    throw fail("found no folder with modules",
               "install Offing as a whole, or set OFFING_MODULE_PATH to the folder with its modules");
  }
  void* const library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    throw fail(last_complaint(),
               "install Offing as a whole, or set OFFING_MODULE_PATH to the folder with its modules");
  }
  const auto* module = static_cast<const Module*>(dlsym(library, "offing_module"));
  if (module == nullptr || module_build() != module->build) {
    throw fail("expected a module of this build of Offing",
               "install Offing's programs, library and modules from one package");
  }
  return module->table;
}

}  // namespace offing
