#pragma once

#include <functional>

#include "host/base/work.h"
#include "present/view_options.h"

namespace offing::present {

/// Makes the pictures that the options ask for, without a window. The same options give the same bytes on the
/// same machine. Throws Error(no_device) where there is no OpenGL or OpenCL, Error(cancelled) when asked to
/// stop: what is not whole by then is not written.
void make_images(const ViewOptions& options, const CancelToken& cancel);

/// Makes the frames of the options' recording alone. `tell` hears how many are written, first of none, once
/// all is prepared. Throws what make_images() throws.
void record_frames(const ViewOptions& options, const CancelToken& cancel,
                   const std::function<void(int written)>& tell);

}  // namespace offing::present
