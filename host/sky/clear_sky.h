#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "host/ocl/buffer.h"
#include "host/ocl/device.h"
#include "host/ocl/kernel.h"
#include "host/sky/atmosphere.h"
#include "host/sky/sun_position.h"
#include "kernels/shared/sky_params.h"

namespace offing::sky {

/// One float4 of the device.
using Texel = std::array<float, 4>;

/// Light at the eye, klx in linear Rec.709.
struct Illuminance {
  Rgb sun_klx{};  ///< of a surface that faces the sun, by the sun alone; 0 when it has set
  Rgb sky_klx{};  ///< of a level surface that looks up, by the sky alone
};

/// What is seen along rays, kcd/m2 in linear Rec.709; the sum of both is the whole.
struct SkyLight {
  std::vector<Rgb> sky_kcdpm2;  ///< without the sun's disc
  std::vector<Rgb> sun_kcdpm2;  ///< the sun's disc alone
};

/// A clear sky lit by the sun: kernels/sky/clear_sky.clh is its radiance function, in OpenCL C and, through
/// clear_sky_glsl(), in GLSL, and reads params() and two of the tables kept here. All light is in kcd/m2,
/// linear Rec.709.
///
/// Below the horizon it shows what a ray that a wave reflects downward would meet: a diffuse sea
/// (ground_albedo) lit by sun and sky, seen through the air between.
///
/// Limits: no stars, moon or air glow, so that the sky goes black when the sun is 17 degrees down; light
/// scattered twice and more has no direction (Hillaire 2020): 8 % of the light in the mean, 19 % at worst by
/// day, twice too bright late at dusk; no refraction (give a sun direction that has it); colours outside
/// Rec.709 are clipped to it.
class ClearSky {
 public:
  /// Makes the tables that depend on the air alone, or takes those that another program made: where host and
  /// device share memory, ocl::DiskCache keeps them. Throws Error(bad_input) as require_valid() does, and
  /// what programs and buffers throw.
  ClearSky(const ocl::Device& device, const Atmosphere& atmosphere);

  /// Enqueues the table of this sun and an eye at this height above the sea. Heights below 1 m count as 1 m,
  /// heights above the air as its top. Up is +y wherever the eye stands. Throws Error(bad_input) unless the
  /// sun's direction is of unit length within 1e-3, its distance within 0.1 ... 100 au, and the eye within
  /// 0 ... 1e9 m.
  void at(const Sun& sun, double eye_altitude_m = 2.0);

  /// Changes with each at(), and is that of no other sky: whoever holds copies of the tables knows by it
  /// whether they are up to date.
  std::uint64_t revision() const { return revision_; }

  /// For the radiance function; tables are [rows][columns] (r, g, b, 0) or four wavelengths, row-major, sizes
  /// in kernels/shared/sky_params.h: view_table of SKY_VIEW_LAYERS * SKY_VIEW_ROWS rows, new after each at();
  /// depth_table of SKY_DEPTH_ROWS, once and for all. As textures: RGBA32F, one row a row, read by
  /// texelFetch.
  const SkyParams& params() const { return params_; }
  const ocl::Buffer<Texel>& view_table() const { return view_table_; }
  const ocl::Buffer<Texel>& depth_table() const { return depth_table_; }
  /// Light scattered twice and more, which only the view table is made of; read by tests.
  const ocl::Buffer<Texel>& scattering_table() const { return scattering_table_; }

  /// Enqueues the sky in all directions, without the sun's disc, which falls between the texels of any map:
  /// map [rows][columns] (r, g, b, 1), row 0 up, columns clockwise from north; kernels/sky/sky_map.cl. Throws
  /// Error(bad_usage) unless the map has columns * rows texels, both at least 1.
  void fill_map(int columns, int rows, ocl::Buffer<Texel>& map) const;

  /// Waits for the illuminance at the eye.
  Illuminance read_illuminance() const;

  /// Waits for what is seen along these unit directions.
  SkyLight read_light(std::span<const std::array<double, 3>> directions) const;

 private:
  void make_air_tables();

  ocl::Device device_;
  Atmosphere atmosphere_;
  AtmosphereParams air_{};
  SkyParams params_{};
  std::uint64_t revision_ = 0;
  ocl::Kernel view_kernel_, map_kernel_, rays_kernel_, illuminance_kernel_;
  ocl::Buffer<Texel> depth_table_, scattering_table_, ground_table_, view_table_;
};

/// The radiance function of kernels/sky/clear_sky.clh as GLSL, for `#version 330 core` and later: the very
/// text that OpenCL compiles, to be placed behind the shader's `#version` line. Gives
///
///   struct SkyParams                                           // std140: the bytes of ClearSky::params()
///   vec3 sky_radiance(SkyParams sky, sampler2D view_table, vec3 direction)
///   vec3 sky_sun_disc(SkyParams sky, sampler2D depth_table, vec3 direction)
///
/// and the sizes of the tables as SKY_... macros. A shader declares `layout(std140) uniform Sky { SkyParams
/// sky; };` and samplers of two RGBA32F textures that hold ClearSky::view_table() and depth_table(), row for
/// row.
///
/// `#line` keeps messages at the lines of the files, which are numbered from 1 in the order that a comment at
/// the top gives. OFFING_KERNEL_PATH is honoured as in ocl::Program. Throws Error(build_failed) as that does.
std::string clear_sky_glsl();

}  // namespace offing::sky
