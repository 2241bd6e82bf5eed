#pragma once

#include <filesystem>
#include <string>

/// Scenes that were installed with the programs.
namespace offing {

/// The folder that holds them, found from where the running program lies; for a program that is not installed
/// it does not exist.
std::filesystem::path installed_scenes();

/// The scene file that a command line means by `written`. A name without a folder that no file in the current
/// folder has, such as world.toml, is that of an installed scene if there is one. All else stays as it is.
std::string find_scene(const std::string& written);

}  // namespace offing
