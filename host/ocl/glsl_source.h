#pragma once

#include <string>
#include <string_view>

namespace offing::ocl {

/// The text of a kernels' header that is written in the common subset of OpenCL C and GLSL
/// (kernels/sky/shading_language.clh) as GLSL, for `#version 330 core` and later, to be placed behind the
/// shader's #version line: the very text that OpenCL compiles. Structs may be those of std140 blocks.
///
/// #line keeps messages at the lines of the files, which are numbered from 1 in the order that a comment at
/// the top gives. Throws Error(build_failed) as assemble_source() does.
std::string glsl_source(std::string_view source_name);

}  // namespace offing::ocl
