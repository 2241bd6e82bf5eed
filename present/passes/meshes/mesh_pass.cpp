#include "present/passes/meshes/mesh_pass.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "present/passes/air.h"
#include "present/passes/camera_projection.h"
#include "present/passes/uniform_bindings.h"

namespace offing::present {
namespace {

constexpr int mesh_environment_unit = 0, faces_unit = 1, ramp_unit = 2;
constexpr int depth_behind_unit = 0, light_behind_unit = 1;
constexpr int light_samples_unit = 0, depth_samples_unit = 1;
// Samples at steps of 8 cannot be told from a smooth edge; where the CPU draws, each one costs.
constexpr int samples_of_gpu = 8, samples_of_cpu = 4;

ShaderProgram begin_program() {
  return ShaderProgram(
      {.vertex = {shader_file("screen.vert")}, .fragment = {shader_file("meshes/mesh_begin.frag")}});
}

ShaderProgram end_program() {
  return ShaderProgram({.vertex = {shader_file("screen.vert")},
                        .fragment = {shader_file("meshes/mesh_uniforms.h"),
                                     uniform_block("MeshEnd", "MeshEndUniforms mesh_end;"),
                                     shader_file("meshes/mesh_end.frag")}});
}

ShaderProgram outline_program() {
  return ShaderProgram(plain_stages({"meshes/mesh_place.glsl", "meshes/mesh_outline.vert"}));
}

void draw_screen(const GlVertexArray& no_vertices) {
  glBindVertexArray(no_vertices.name());
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_ALWAYS);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

/// Meshes send no light where highlights stand alone. They take that of the highlights that they hide.
void set_base_light(HighlightShow highlights) {
  const GLboolean writes = highlights == HighlightShow::unobstructed ? GL_FALSE : GL_TRUE;
  glColorMask(writes, writes, writes, writes);
  (highlights == HighlightShow::only ? glEnable : glDisable)(GL_BLEND);
  glBlendFunc(GL_ZERO, GL_ZERO);
}

}  // namespace

MeshPass::MeshPass(const GlCapabilities& capabilities)
    : capabilities_(capabilities),
      begin_(begin_program()),
      outline_(outline_program()),
      end_(end_program()),
      bases_(base_program),
      base_block_("Mesh", pass_binding),
      outline_block_("Plain", pass_binding),
      end_block_("MeshEnd", pass_binding),
      no_vertices_(GlVertexArray::make()) {}

ShaderProgram MeshPass::base_program(const BaseFeatures& features) {
  const ShaderPart compiled_for{"features of meshes",
                                fmt::format("#define SHADING {:d}\n#define SHOWS_CURVATURE {:d}\n",
                                            static_cast<int>(features.shading), features.shows_curvature)};
  std::vector<ShaderPart> vertex =
      mesh_uniforms("Mesh", "ViewUniforms view; MeshMatrices matrices; MeshUniforms mesh;");
  for (const ShaderPart& part :
       {uniform_block("Lights", "LightUniforms lighting;"), compiled_for, CloudShadows::glsl()})
    vertex.push_back(part);
  std::vector<ShaderPart> fragment = vertex;
  for (const char* name : {"meshes/mesh_place.glsl", "meshes/mesh_light.glsl", "meshes/mesh.vert"})
    vertex.push_back(shader_file(name));
  for (const char* name : {"sky/environment.glsl", "air.glsl", "meshes/mesh_light.glsl", "meshes/mesh.frag"})
    fragment.push_back(shader_file(name));
  return ShaderProgram({.vertex = std::move(vertex), .fragment = std::move(fragment)});
}

void MeshPass::prepare(const world::World& world) {
  const std::vector<world::WorldMesh>& views = world.meshes();
  if (meshes_.size() > views.size())
    meshes_.erase(meshes_.begin() + static_cast<std::ptrdiff_t>(views.size()), meshes_.end());
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (i < meshes_.size() && meshes_[i].revision == views[i].revision()) continue;
    Mesh mesh{views[i].revision(), MeshGeometry(views[i].surface())};
    if (i < meshes_.size()) {
      meshes_[i] = std::move(mesh);
    } else {
      meshes_.push_back(std::move(mesh));
    }
  }
}

PixelBox MeshPass::pixels(const world::World& world, const Camera& camera) const {
  PixelBox box;
  for (std::size_t i = 0; i < meshes_.size(); ++i) {
    const world::WorldMesh& view = world.meshes()[i];
    if (!view.is_visible()) continue;
    const MeshViewMatrices matrices(view, camera, capabilities_, MeshPart::all, world.sea_level_m());
    box = around(box, pixels_of(meshes_[i].geometry.low_m(), meshes_[i].geometry.high_m(), matrices, camera,
                                1.0 + view.parameters().material.outline_px));
  }
  return box;
}

void MeshPass::begin(const RenderTarget& target) {
  if (samples_.width() != target.width() || samples_.height() != target.height()) {
    samples_ = MultisampleTarget(target.width(), target.height(),
                                 capabilities_.is_software ? samples_of_cpu : samples_of_gpu);
  }
  samples_.bind();
  begin_.use();
  bind_sampler(begin_, "depth_behind", depth_behind_unit, target.depth_texture());
  bind_sampler(begin_, "light_behind", light_behind_unit, target.texture());
  draw_screen(no_vertices_);
}

void MeshPass::draw_base(const world::World& world, std::size_t index, const MeshViewMatrices& matrices,
                         const FrameRequest& request, GLuint environment) {
  const world::WorldMesh& view = world.meshes()[index];
  const world::MeshMaterial& material = view.parameters().material;
  const ShaderProgram& base =
      bases_.with({.shading = material.shading, .shows_curvature = request.meshes == MeshShow::curvature});
  base.use();
  lights_.bind(base);
  bind_sampler(base, "environment", mesh_environment_unit, environment);
  meshes_[index].geometry.bind_faces(faces_unit);
  base.set("faces", faces_unit);
  const bool is_grey = request.meshes == MeshShow::directions;
  glsl::ViewUniforms seen = view_uniforms(request.camera);
  seen.white_kcdpm2 = static_cast<float>(1.0 / request.exposure);
  seen.haze_perm = haze_perm(world.parameters().atmosphere);
  base_block_.fill(seen, matrices.uniforms(),
                   {.colour = is_grey ? glm::vec3(0.3f) : glm::vec3(material.colour),
                    .specular = static_cast<float>(material.specular),
                    .shininess = static_cast<float>(material.shininess),
                    .cartoon_steps = material.cartoon_steps,
                    .has_ramp = material.cartoon_ramp >= 0 ? 1 : 0,
                    .length_of_mesh_m = static_cast<float>(view.surface().diagonal_m())});
  base_block_.bind(base);
  bind_sampler(base, "ramp_image", ramp_unit,
               pictures_.texture(world.parameters().pictures, material.cartoon_ramp, ImageUse::ramp));
  glDepthFunc(GL_GREATER);
  glPolygonMode(GL_FRONT_AND_BACK, request.fill == Fill::wireframe ? GL_LINE : GL_FILL);
  meshes_[index].geometry.draw();
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}

void MeshPass::draw_outline(std::size_t index, const MeshViewMatrices& matrices, const FrameRequest& request,
                            const world::MeshMaterial& material) {
  outline_.use();
  outline_block_.fill(matrices.uniforms(),
                      {.light = {glm::vec3(material.outline_colour / request.exposure), 1.0f},
                       .half_image_px = 0.5f * glm::vec2(request.camera.width_px, request.camera.height_px),
                       .outline_px = static_cast<float>(material.outline_px)});
  outline_block_.bind(outline_);
  glEnable(GL_CULL_FACE);
  glCullFace(GL_FRONT);
  meshes_[index].geometry.draw();
  glDisable(GL_CULL_FACE);
  meshes_[index].geometry.draw_borders();
}

void MeshPass::draw_mesh(const world::World& world, std::size_t index, const FrameRequest& request,
                         GLuint environment, MeshPart part) {
  const world::WorldMesh& view = world.meshes()[index];
  if (!view.is_visible()) return;
  const MeshViewMatrices matrices(view, request.camera, capabilities_, part, world.sea_level_m());
  set_base_light(request.highlights);
  draw_base(world, index, matrices, request, environment);
  if (view.parameters().material.outline_px > 0.0 && request.fill == Fill::solid) {
    draw_outline(index, matrices, request, view.parameters().material);
  }
  set_base_light(HighlightShow::shown);
  if (request.meshes == MeshShow::directions) lines_.draw_directions(view, matrices, request);
  if (request.meshes == MeshShow::curvature || request.meshes == MeshShow::directions) return;
  if (request.highlights == HighlightShow::hidden) return;
  highlights_.draw(view, meshes_[index].geometry, matrices, request,
                   {.world = world, .lights = lights_, .pictures = pictures_, .environment = environment});
  if (request.meshes == MeshShow::projectors) lines_.draw_projectors(view, matrices, request);
}

void MeshPass::end(const RenderTarget& target, const FrameRequest& request) {
  target.bind();
  end_.use();
  samples_.bind_samples(light_samples_unit, depth_samples_unit);
  end_.set("samples_of", light_samples_unit);
  end_.set("depth_of", depth_samples_unit);
  end_block_.fill({.sample_count = samples_.samples(),
                   .exposure = static_cast<float>(request.exposure),
                   .is_layer = is_alone(request.highlights) ? 1 : 0});
  end_block_.bind(end_);
  draw_screen(no_vertices_);
}

void MeshPass::draw(const world::World& world, const FrameRequest& request, GLuint environment,
                    const CloudShadows& shadows, const RenderTarget& target) {
  const PixelBox box = pixels(world, request.camera);
  if (box.width <= 0 || box.height <= 0) return;
  lights_.prepare(world, request.camera.eye_m, shadows);
  glEnable(GL_SCISSOR_TEST);
  glScissor(box.left, box.bottom, box.width, box.height);
  begin(target);
  for (std::size_t i = 0; i < meshes_.size(); ++i) {
    // No mesh before it hides a highlight that is unobstructed.
    if (request.highlights == HighlightShow::unobstructed) glClear(GL_DEPTH_BUFFER_BIT);
    draw_mesh(world, i, request, environment, MeshPart::all);
  }
  end(target, request);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_DEPTH_TEST);
}

void MeshPass::draw_plainly(const world::World& world, const FrameRequest& request, GLuint environment,
                            const CloudShadows& shadows, MeshPart part, const RenderTarget& target) {
  if (meshes_.empty()) return;
  lights_.prepare(world, request.camera.eye_m, shadows);
  // In water, highlights belong to the picture below those of the meshes themselves.
  FrameRequest seen = request;
  seen.highlights = HighlightShow::shown;
  target.bind();
  glEnable(GL_DEPTH_TEST);
  // Some drivers clip all the same where it is not enabled: what is not cut has no distance to be clipped at.
  if (part == MeshPart::above_sea) glEnable(GL_CLIP_DISTANCE0);
  for (std::size_t i = 0; i < meshes_.size(); ++i) draw_mesh(world, i, seen, environment, part);
  glDisable(GL_CLIP_DISTANCE0);
  glDisable(GL_DEPTH_TEST);
}

}  // namespace offing::present
