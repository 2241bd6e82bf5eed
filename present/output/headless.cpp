#include "present/output/headless.h"

#include <filesystem>
#include <functional>
#include <optional>

#include "host/base/progress.h"
#include "host/command_line/print_results.h"
#include "host/ocl/device_list.h"
#include "present/output/highlight_layer.h"
#include "present/output/image_file.h"
#include "present/output/recorder.h"
#include "present/output/scene_images.h"

namespace offing::present {
namespace {

/// Draws pictures for files, with what the options want to see of highlights.
class Pictures {
 public:
  Pictures(const ViewOptions& options, const CancelToken& cancel)
      : images_(options.scene, ocl::select_device(options.device),
                frame_settings(options.detail.value_or(Detail::high), options.transfer), cancel),
        size_(options.size.value_or(ImageSize{})),
        highlights_(options.highlights),
        cancel_(cancel) {}

  /// A picture of a sequence that begins at `first_s`. False when asked to stop.
  bool draw(double time_s, double first_s) {
    time_s_ = time_s;
    if (!is_alone(highlights_)) return images_.draw(time_s, first_s, size_, cancel_, highlights_);
    layer_ = images_.draw_highlights(time_s, first_s, size_, cancel_, highlights_);
    return layer_.has_value();
  }

  // Of the last draw().
  void write(const std::filesystem::path& file, Existing existing) const {
    if (layer_) {
      write_layer(file, *layer_, time_s_, images_.exposure(), existing);
    } else {
      write_image(file, images_.frame(), time_s_, images_.exposure(), existing);
    }
  }
  void write(Recorder& recorder) const {
    if (layer_) {
      recorder.write(*layer_, time_s_, images_.exposure());
    } else {
      recorder.write(images_.frame(), time_s_, images_.exposure());
    }
  }

 private:
  SceneImages images_;
  ImageSize size_;
  HighlightShow highlights_;
  const CancelToken& cancel_;
  double time_s_ = 0.0;
  std::optional<HighlightLayer> layer_;  // where highlights stand alone
};

/// Makes all frames of a recording; `tell` hears how many are written.
void record(Pictures& pictures, const Recording& recording, const std::function<void(int)>& tell) {
  Recorder recorder(recording);
  tell(0);
  for (int frame = recording.frames.first; frame <= recording.frames.last; ++frame) {
    if (!pictures.draw(frame / recording.frames_per_second, recording.first_s())) {
      throw stopped_recording(recording, recorder.count());
    }
    pictures.write(recorder);
    tell(recorder.count());
  }
  recorder.finish();
}

}  // namespace

void make_images(const ViewOptions& options, const CancelToken& cancel) {
  Pictures pictures(options, cancel);
  if (!options.output.empty()) {
    if (!pictures.draw(options.time_s, options.time_s)) cancel.throw_if_cancelled();
    pictures.write(options.output, options.existing);
    print_summary("{}\n", options.output.string());
  }
  if (!options.recording) return;
  {
    Progress progress(options.recording->count(), "frames", options.verbosity);
    record(pictures, *options.recording, [&](int written) {
      if (written > 0) progress.advance();
    });
  }
  print_summary("{}\n", shown_outputs(*options.recording));
}

void record_frames(const ViewOptions& options, const CancelToken& cancel,
                   const std::function<void(int)>& tell) {
  Pictures pictures(options, cancel);
  record(pictures, *options.recording, tell);
}

}  // namespace offing::present
