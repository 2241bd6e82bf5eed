#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "host/base/triangle_mesh.h"
#include "host/highlights/projectors/highlight_rule.h"
#include "host/highlights/search/highlight_surface.h"
#include "host/highlights/search/lighting.h"
#include "host/highlights/tracks/highlight_track.h"

namespace offing::world {

/// How a mesh is shaded below its highlights.
enum class BaseShading { phong, gouraud, cartoon, flat };

/// Whether a mesh is drawn.
enum class MeshVisibility { off, on };

/// What a mesh looks like without its highlights. Colours are linear Rec.709.
struct MeshMaterial {
  BaseShading shading = BaseShading::phong;
  glm::dvec3 colour{0.5};   ///< diffuse reflectance
  double specular = 0.0;    ///< reflectance of Blinn's own highlight, 0: none
  double shininess = 40.0;  ///< its exponent
  int cartoon_steps = 3;    ///< of BaseShading::cartoon
  int cartoon_ramp = -1;    ///< in their place a picture of the world's, from dark at its left to bright
  double outline_px = 0.0;  ///< 0: none
  glm::dvec3 outline_colour{0.0};
  MeshVisibility visible = MeshVisibility::on;
};

/// A light beside the sun.
struct Light {
  highlights::Source source;      ///< in the world's axes
  glm::dvec3 colour{1.0};         ///< linear Rec.709
  double illuminance_klx = 50.0;  ///< at the meshes and clouds, whatever the distance
};

/// A mesh of a world with its highlights.
struct MeshParameters {
  std::string name;  ///< for messages
  std::shared_ptr<const TriangleMesh> mesh;
  std::shared_ptr<const VertexCurvatures> curvatures = {};  ///< none: made on the device
  Deformation deformation = {};  ///< of the mesh; its curvatures are then made on the device at each time
  std::function<highlights::RigidMotion(double time_s)> motion;  ///< the same for the same time
  MeshMaterial material;
  highlights::SurfaceOptions surface;
  highlights::TrackOptions tracks;
  bool has_highlights = true;
  std::vector<highlights::HighlightRule> rules;  ///< at the time that is shown
};

}  // namespace offing::world
