#pragma once

#include "host/base/work.h"
#include "present/view_options.h"

namespace offing::present {

/// Writes the clouds of the options' scene as they are drawn and as paths traced in double precision have
/// them (clouds::ReferenceTracer), side by side with what differs, into the folder of options.comparison, and
/// prints how much light there is in both and in each order of scattering. Needs no OpenGL. The same options
/// give the same bytes on the same machine.
///
/// Files: drawn.png, reference.png, error.png, compared.exr with the light of both and of each order.
/// Throws Error(bad_input) for a scene without clouds or with clouds of several looks, Error(file) for files
/// that are there and may not be replaced, Error(cancelled) when asked to stop: nothing is written then.
void compare_with_reference(const ViewOptions& options, const CancelToken& cancel);

}  // namespace offing::present
