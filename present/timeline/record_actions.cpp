#include "present/timeline/record_actions.h"

#include <algorithm>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/command_line/new_output.h"
#include "host/io/file_presence.h"
#include "host/scene/file/scene_files.h"
#include "present/output/camera_path.h"
#include "present/output/video_pipe.h"

namespace offing::present {

RecordActions::~RecordActions() {
  job_.reset();
  remove_empty_folder();
}

void RecordActions::open() {
  if (options_.recording || is_recording()) {
    state_.message = {.text = "a recording is running: wait until it ends, or cancel it", .is_fault = true};
    return;
  }
  const scene::TimeSection& time = state_.scene.time;
  RecordingRequest request =
      last_.value_or(RecordingRequest{.format = has_ffmpeg() ? RecordFormat::mp4 : RecordFormat::png,
                                      .size = options_.size.value_or(ImageSize{}),
                                      .detail = options_.detail.value_or(Detail::high)});
  request.start_s = time.start_s;
  request.seconds = std::max(time.end_s - time.start_s, 1.0 / time.frames_per_second);
  request.frames_per_second = time.frames_per_second;
  request.replaces = false;
  request.has_path = has_camera_path(state_.scene);
  request.name = unused_record_name(options_.scene_name.empty() ? "offing" : options_.scene_name);
  dialog_.open(request);
}

/// Files that the user has not asked to be replaced.
void RecordActions::refuse_taken(const Recording& recording) const {
  const auto refuse = [](const std::filesystem::path& file) {
    throw Error(ErrorKind::bad_usage, fmt::format("{} exists already", one_line(file.filename().string())),
                "choose another name, or tick \"replace existing files\"");
  };
  if (recording.existing == Existing::replace) return;
  if (!recording.name) {
    if (is_taken(recording.video)) refuse(recording.video);
    return;
  }
  const std::vector<std::filesystem::path> taken = existing_frames(*recording.name, recording.frames);
  if (!taken.empty()) refuse(taken.front());
}

void RecordActions::make_folder(const Recording& recording) {
  if (!recording.name || !dialog_.request().has_folder) return;
  const std::filesystem::path folder = recording.name->of(recording.frames.first).parent_path();
  std::error_code failure;
  if (std::filesystem::create_directory(folder, failure)) made_folder_ = folder;
  if (failure) {
    throw Error(ErrorKind::file,
                fmt::format("{}: cannot create the folder: {}", one_line(folder.string()), failure.message()),
                "choose another name or folder");
  }
}

/// The folder that was made for pictures, if none were written.
void RecordActions::remove_empty_folder() {
  std::error_code has_files;
  if (!made_folder_.empty()) std::filesystem::remove(made_folder_, has_files);
  made_folder_.clear();
}

void RecordActions::begin() {
  const RecordingRequest& request = dialog_.request();
  try {
    const Recording recording = recording_of(request);
    ViewOptions options;
    options.scene = state_.scene;
    options.size = ImageSize{fitting_side(recording.video, request.size.width),
                             fitting_side(recording.video, request.size.height)};
    options.detail = request.detail;
    options.recording = recording;
    options.transfer = options_.transfer;
    options.device = options_.device;
    // The window has shown their warnings. The camera is where the user sees from, not where the ground would
    // place it.
    options.scene.set_at = {{"camera.x_m", "the window"}};
    refuse_taken(recording);
    make_folder(recording);
    require_recording(recording, {scene::files_of(options.scene), options.scene.trust});
    job_ = std::make_unique<RecordingJob>(std::move(options));
    last_ = request;
    dialog_.close();
    state_.message = {};
  } catch (const Error& error) {
    remove_empty_folder();
    dialog_.refuse(fault_message(error).text);
  }
}

std::optional<RecordingProgress> RecordActions::progress() const {
  if (!job_) return {};
  return job_->progress();
}

void RecordActions::cancel() {
  if (job_) job_->cancel();
}

void RecordActions::turn() {
  if (!job_ || !job_->has_ended()) return;
  const std::unique_ptr<RecordingJob> job = std::move(job_);
  const Recording& recording = job->recording();
  try {
    job->take();
    state_.message = {.text = fmt::format("wrote {}", shown_outputs(recording))};
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::cancelled) {
      state_.message = fault_message(error);
    } else if (recording.video.empty()) {
      const int written = job->progress().written;
      state_.message = {.text =
                            fmt::format("cancelled: wrote {} of {} pictures", written, recording.count())};
    } else {
      state_.message = {.text = "cancelled: wrote no video"};
    }
  }
  remove_empty_folder();
}

void RecordActions::for_shown_names(const std::function<void(std::string_view)>& tell) const {
  if (!dialog_.is_open()) return;
  dialog_.for_shown_names(tell);
}

void RecordActions::draw(ImageSize window) {
  if (dialog_.draw(window, state_.clock.time_s())) begin();
}

}  // namespace offing::present
