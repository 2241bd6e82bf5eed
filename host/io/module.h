#pragma once

#include <filesystem>
#include <string>
#include <string_view>

/// Modules: code that needs a large library, each in a shared library of ours that is loaded when first
/// needed. Programs then start faster, and liboffing loads neither GDAL nor OpenVDB by itself.
namespace offing {

/// What a module exports, by the name `offing_module`.
struct Module {
  const char* build;  ///< module_build() of the sources that it was made from
  const void* table;  ///< its functions
};

/// Version and compiler, in which a program and its modules must agree: tables of another version may hold
/// functions of other types.
std::string_view module_build();

/// The folder with the modules: $OFFING_MODULE_PATH, else the first folder "offing" that exists beside the
/// file that holds this code, in the library folder that belongs to the program's, and in that of the
/// installation. Empty if there is none.
std::filesystem::path module_folder();

/// The table of functions of the module in the file `name`.so, which stays loaded. `purpose` completes
/// "cannot ...". Throws Error(file) for a module that is missing, needs a library that is missing, or is of
/// another build. Safe from several threads.
const void* module_table(std::string_view name, std::string_view purpose);

/// The same, typed.
template <class Table>
const Table& module_functions(std::string_view name, std::string_view purpose) {
  return *static_cast<const Table*>(module_table(name, purpose));
}

}  // namespace offing

/// Defines what a module exports; its table is an object of static storage.
#define OFFING_MODULE(table_of_module)                                                  \
  extern "C" __attribute__((visibility("default"))) const offing::Module offing_module; \
  const offing::Module offing_module {                                                  \
    OFFING_BUILD, &(table_of_module)                                                    \
  }
