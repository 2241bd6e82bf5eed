#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "host/scene/model/scene.h"
#include "present/editing/handle_geometry.h"

namespace offing::present {

/// A [[cloud]] of a scene, or one of its balls.
struct CloudPart {
  std::size_t cloud = 0;
  std::optional<std::size_t> ball = {};  ///< none: all of it

  bool operator==(const CloudPart&) const = default;
};

/// Whether the scene has it. The balls of a genus count where the cloud has none of its own.
bool has_part(const scene::Scene& scene, const CloudPart& part);

/// Hidden clouds are not drawn, and a click does not pick them.
bool is_hidden(const scene::Scene& scene, std::size_t cloud);

/// Where the axes of a cloud are in the world at a time.
glm::dvec3 origin_of_cloud(const scene::Scene& scene, std::size_t cloud, double time_s);

/// The balls of a cloud in the world at a time; none of one that has a shape in their place.
std::vector<Sphere> balls_of(const scene::Scene& scene, std::size_t cloud, double time_s);

/// The balls that a scene says of a cloud. One without any gets those of its genus: it stays as it is.
std::vector<clouds::Metaball>& own_balls(scene::Scene& scene, std::size_t cloud);

/// Pushes a part of a cloud; the whole of one with keyframes along with all of them. Whatever leaves the
/// range of its row of the parameter table stops at its end.
void move_part(scene::Scene& scene, const CloudPart& part, const glm::dvec3& way_m);

/// Makes a part larger or smaller about its middle, or its cloud's.
void resize_part(scene::Scene& scene, const CloudPart& part, double ratio);

/// Takes parts away; a cloud without its last ball goes too.
void remove_parts(scene::Scene& scene, std::vector<CloudPart> parts);

/// The same again, `way_m` beside it, at the end of the list; balls in their clouds. In the order of the
/// parts.
std::vector<CloudPart> duplicate_parts(scene::Scene& scene, const std::vector<CloudPart>& parts,
                                       const glm::dvec3& way_m);

/// A ball at a place of the world at a time, beside the others of its cloud; without one, of a new cloud of
/// the genus about it.
CloudPart add_ball(scene::Scene& scene, std::optional<std::size_t> cloud, clouds::Genus genus,
                   const Sphere& ball, double time_s);

/// A cloud of a genus, its origin at a place of the world.
CloudPart add_cloud(scene::Scene& scene, clouds::Genus genus, const glm::dvec3& place_m);

/// Makes a cloud one of a genus in all but its name, place, motion, scale, seed and the balls and edits that
/// it has of its own.
void apply_genus(scene::Scene& scene, std::size_t cloud, clouds::Genus genus);

}  // namespace offing::present
