#pragma once

#include <filesystem>
#include <string>

namespace offing::ocl {

/// Folders of compiled kernels, which drivers run: what another user could have put there must not be used.

/// What is wrong with a folder: it, or a link that leads to it, belongs to another user, or others than its
/// owner may write in it. Empty if it is ours alone or not there yet.
std::string trouble_with_folder(const std::filesystem::path& folder);

/// Makes the folder, which only its owner may enter, and those above it. Returns why it cannot be used: what
/// the system says, or as trouble_with_folder(); empty if it can.
std::string make_private_folder(const std::filesystem::path& folder);

}  // namespace offing::ocl
