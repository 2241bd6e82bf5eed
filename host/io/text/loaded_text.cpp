// The functions of text_mesh.h as the module `cairo` has them.
#include "host/io/module.h"
#include "host/io/text/cairo_module.h"

namespace offing {

TriangleMesh text_mesh(std::string_view text, const TextMeshOptions& options) {
  return module_functions<text::CairoModule>("cairo", "make meshes of letters").text_mesh(text, options);
}

}  // namespace offing
