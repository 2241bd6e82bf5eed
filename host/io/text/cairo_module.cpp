#include "host/io/text/cairo_module.h"

#include "host/io/module.h"

namespace offing::text {
namespace {

constexpr CairoModule table{.text_mesh = text_mesh};

}  // namespace
}  // namespace offing::text

OFFING_MODULE(offing::text::table);
