// The schemas of the sections of a scene: keys, units, ranges and words of all its values.
#pragma once

#include <vector>

#include "host/base/numbers/degrees.h"
#include "host/scene/schema/schema.h"

namespace offing::scene {

Schema<WorldSection> world_schema();
Schema<TimeSection> time_schema();
Schema<ocean::Wind> wind_schema();
Schema<OceanSection> ocean_schema();
Schema<SwellScene> swell_schema();
Schema<ocean::Raindrop> raindrop_schema();
Schema<WakeScene> wake_schema();

Schema<ViewScene> camera_schema();
Schema<ViewScene> walk_schema();
Schema<ViewScene> render_schema();
Schema<ViewScene> sun_schema();
Schema<ViewScene> sky_schema();
Schema<BookmarkScene> bookmark_schema();

Schema<TerrainScene> terrain_schema();
Schema<terrain::Material> material_schema();
Schema<CanopyScene> canopy_schema();
Schema<LakeScene> lake_schema();
Schema<LightScene> light_schema();
Schema<MeshScene> mesh_schema();
Schema<HighlightScene> highlight_schema();
Schema<BodyScene> body_schema();

Schema<CloudsScene> clouds_schema();
Schema<CloudLayerScene> cloud_layer_schema();
Schema<CloudScene> cloud_schema();
Schema<clouds::ParticleEdit> particle_edit_schema();
/// Rows of [[cloud]]: its shape in place of balls, noise, look and motion.
std::vector<Row<CloudScene>> cloud_shape_rows();

}  // namespace offing::scene
