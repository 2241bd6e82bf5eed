#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace offing::ocl {

/// The text of `source_name` ("ocean/spectrum_advance.cl") with each `#include "path/below/kernels"` line
/// replaced by that file, each file once, wherever it stands (a guard around an `#include` has no effect). A
/// leading "kernels/" in the path is allowed, so that shared headers read alike on both sides. `#line`
/// directives keep compiler messages at the true file and line: "kernels/<name>", or the path under the
/// folder OFFING_KERNEL_PATH when it was read there. A file that this folder lacks comes from the embedded
/// text. Throws Error(build_failed) that names the missing file and the line that includes it.
std::string assemble_source(std::string_view source_name);

/// A compiler's message with the file and line that it means, where it begins with a line of the assembled
/// source ("<kernel>:9:"): some drivers ignore `#line` directives.
std::string at_true_line(std::string_view source, const std::string& message);

/// The files of this source that OFFING_KERNEL_PATH replaces with another text, by their names below
/// kernels/.
std::vector<std::string> replaced_files(std::string_view source_name);

/// The text of a kernels' header that is written in the common subset of OpenCL C and GLSL
/// (kernels/sky/shading_language.clh) as GLSL, for `#version 330 core` and later, to be placed behind the
/// shader's `#version` line: the very text that OpenCL compiles. Structs may be those of std140 blocks.
///
/// `#line` keeps messages at the lines of the files, which are numbered from 1 in the order that a comment at
/// the top gives. Throws Error(build_failed) as assemble_source() does.
std::string glsl_source(std::string_view source_name);

}  // namespace offing::ocl
