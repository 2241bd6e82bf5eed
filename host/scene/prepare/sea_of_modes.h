#pragma once

#include "host/scene/prepare/sea.h"

namespace offing::scene {

/// The sea of [ocean] modes_file: its waves on patches as cascades, those alone beside them, as swells are.
/// Patches, size and choppiness are the file's, depth and loop too where the scene gives none; the spectrum
/// is that of the waves. prepare_sea() adds what all seas have. Throws Error(bad_input) for a file that
/// cannot be read, or has no wave on a patch, and for an irregular swell.
Sea sea_of_modes(const Scene& scene);

}  // namespace offing::scene
