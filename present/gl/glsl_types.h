#pragma once

#include <glm/ext/vector_int2.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

/// GLSL's types as std140 lays them out (OpenGL 3.3, 2.12.6.4), for structs of uniforms that C++ and GLSL
/// both read. Use arrays of vec4 and mat4 only: std140 pads the elements of all others.
namespace offing::present::glsl {

using vec2 [[gnu::aligned(8)]] = glm::vec2;
using ivec2 [[gnu::aligned(8)]] = glm::ivec2;
using vec3 [[gnu::aligned(16)]] = glm::vec3;  // a scalar fits behind it, in the same 16 bytes
using vec4 [[gnu::aligned(16)]] = glm::vec4;
using mat4 [[gnu::aligned(16)]] = glm::mat4;

}  // namespace offing::present::glsl
