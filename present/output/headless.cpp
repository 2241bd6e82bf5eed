#include "present/output/headless.h"

#include "host/base/progress.h"
#include "host/command_line/print_results.h"
#include "host/ocl/device_list.h"
#include "present/output/image_file.h"
#include "present/output/recorder.h"
#include "present/output/scene_images.h"

namespace offing::present {

void make_images(const ViewOptions& options, const CancelToken& cancel) {
  SceneImages images(options.scene, ocl::select_device(options.device),
                     frame_settings(options.detail.value_or(Detail::high), options.transfer), cancel);
  const ImageSize size = options.size.value_or(ImageSize{});
  if (!options.output.empty()) {
    if (!images.draw(options.time_s, options.time_s, size, cancel)) cancel.throw_if_cancelled();
    write_image(options.output, images.frame(), options.time_s, images.exposure(), options.existing);
    print_summary("{}\n", options.output.string());
  }
  if (!options.recording) return;
  const Recording& recording = *options.recording;
  Recorder recorder(recording);
  {
    Progress progress(recording.count(), "frames", options.verbosity);
    for (int frame = recording.frames.first; frame <= recording.frames.last; ++frame) {
      const double time_s = frame / recording.frames_per_second;
      if (!images.draw(time_s, recording.first_s(), size, cancel)) {
        throw stopped_recording(recording, recorder.count());
      }
      recorder.write(images.frame(), time_s, images.exposure());
      progress.advance();
    }
  }
  recorder.finish();
  print_summary("{}\n", shown_outputs(recording));
}

}  // namespace offing::present
