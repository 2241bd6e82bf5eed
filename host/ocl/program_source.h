#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace offing::ocl {

/// The text of `source_name` ("ocean/spectrum_advance.cl") with each `#include "path/below/kernels"` line
/// replaced by that file, each file once, wherever it stands (a guard around an #include has no effect). A
/// leading "kernels/" in the path is allowed, so that shared headers read alike on both sides. #line
/// directives keep compiler messages at the true file and line: "kernels/<name>", or the path under the
/// folder OFFING_KERNEL_PATH when it was read there. A file that this folder lacks comes from the embedded
/// text. Throws Error(build_failed) that names the missing file and the line that includes it.
std::string assemble_source(std::string_view source_name);

/// The files of this source that OFFING_KERNEL_PATH replaces with another text, by their names below
/// kernels/.
std::vector<std::string> replaced_files(std::string_view source_name);

}  // namespace offing::ocl
