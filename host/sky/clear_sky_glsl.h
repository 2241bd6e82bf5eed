#pragma once

#include <string>

namespace offing::sky {

/// The radiance function of kernels/sky/clear_sky.clh as GLSL, for `#version 330 core` and later: the very
/// text that OpenCL compiles, to be placed behind the shader's #version line. Gives
///
///   struct SkyParams                                           // std140: the bytes of ClearSky::params()
///   vec3 sky_radiance(SkyParams sky, sampler2D view_table, vec3 direction)
///   vec3 sky_sun_disc(SkyParams sky, sampler2D depth_table, vec3 direction)
///
/// and the sizes of the tables as SKY_... macros. A shader declares `layout(std140) uniform Sky { SkyParams
/// sky; };` and samplers of two RGBA32F textures that hold ClearSky::view_table() and depth_table(), row for
/// row.
///
/// #line keeps messages at the lines of the files, which are numbered from 1 in the order that a comment at
/// the top gives. OFFING_KERNEL_PATH is honoured as in ocl::Program. Throws Error(build_failed) as that does.
std::string clear_sky_glsl();

}  // namespace offing::sky
