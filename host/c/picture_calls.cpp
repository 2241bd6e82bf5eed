#include <memory>

#include "host/c/handles.h"
#include "host/io/module.h"
#include "host/scene/prepare/scene_renderer.h"

using offing::c::require;
using offing::c::run;
using offing::c::Use;

struct OffingRenderer : offing::c::OneAtATime {
  explicit OffingRenderer(std::unique_ptr<offing::scene::SceneRenderer> of) : renderer(std::move(of)) {}

  std::unique_ptr<offing::scene::SceneRenderer> renderer;
};

OffingStatus offing_make_renderer(const OffingDevice* device, const OffingScene* scene,
                                  OffingRenderer** renderer) {
  return run([&] {
    require(device, "device");
    require(scene, "scene");
    require(renderer, "renderer");
    const auto& present = offing::module_functions<offing::scene::PresentModule>("present", "draw pictures");
    *renderer = new OffingRenderer(present.make_renderer(scene->copy(), device->device.info()));
  });
}

OffingStatus offing_render(OffingRenderer* renderer, const OffingPicture* picture) {
  return run([&] {
    const Use use(renderer, "renderer");
    require(picture, "picture");
    const OffingPicture wanted = offing::c::read_struct(picture, "picture");
    const auto values = static_cast<std::size_t>(std::max(wanted.width_px, 0)) *
                        static_cast<std::size_t>(std::max(wanted.height_px, 0)) * 3;
    offing::scene::PictureRequest request{
        .time_s = wanted.time_s, .width_px = wanted.width_px, .height_px = wanted.height_px};
    if (wanted.rgb != nullptr) request.rgb = {wanted.rgb, values};
    if (wanted.light != nullptr) request.light = {wanted.light, values};
    renderer->renderer->draw(request);
  });
}

void offing_free_renderer(OffingRenderer* renderer) {
  delete renderer;
}
