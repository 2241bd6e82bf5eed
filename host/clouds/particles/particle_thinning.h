#pragma once

#include <span>
#include <vector>

#include "kernels/shared/clouds.h"

namespace offing::clouds {

/// Halvings beyond which a cloud's form is lost.
inline constexpr int most_particle_halvings = 2;

/// Throws Error(bad_usage) for halvings outside 0 ... most_particle_halvings.
void require_halvings(int halvings);

/// Fewer particles in the place of a cloud's: two neighbours of about one size become one, or four with two
/// halvings. The heaviest of them stands for all, with the optical mass and the mean albedo of all, in the
/// middle of their mass. It is as wide as spreads that mass as far as theirs (equal second moments), but has
/// no larger a volume than all of them: of alike particles a share s is left, 1 / s times as heavy and
/// s^(-1/3) times as wide at most. Sizes are told apart by octaves of the radius, so that each level of a
/// hierarchy gives up its share; of all sizes the largest sixteenth of the particles stay as they are, on
/// which its form hangs.
///
/// Depends on the particles alone. They stay in their order, with their ids, textures and turns; those of two
/// halvings are among those of one; 0 gives all particles as they are. Throws as require_halvings().
std::vector<CloudParticle> thinned_particles(std::span<const CloudParticle> particles, int halvings);

}  // namespace offing::clouds
