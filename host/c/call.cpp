#include "host/c/call.h"

#include <memory>
#include <mutex>
#include <utility>

#include <spdlog/sinks/base_sink.h>

#include "host/base/log.h"
#include "host/scene/file/version.h"

namespace offing::c {
namespace {

struct LastFailure {
  std::string error, hint;
};
thread_local LastFailure last_failure;

/// Hands each line to the program.
class CallbackSink : public spdlog::sinks::base_sink<std::mutex> {
 public:
  CallbackSink(OffingLog log, void* user) : log_(log), user_(user) {}

 protected:
  void sink_it_(const spdlog::details::log_msg& message) override {
    const std::string line(message.payload.data(), message.payload.size());
    log_(user_, level_of(message.level), line.c_str());
  }
  void flush_() override {}

 private:
  static OffingLogLevel level_of(spdlog::level::level_enum level) {
    if (level >= spdlog::level::err) return OFFING_LOG_ERROR;
    if (level == spdlog::level::warn) return OFFING_LOG_WARNING;
    return level == spdlog::level::info ? OFFING_LOG_INFO : OFFING_LOG_DEBUG;
  }

  OffingLog log_;
  void* user_;
};

/// The log of a library by default.
void warnings_to_stderr() {
  configure_log(Verbosity::normal);
  spdlog::set_level(spdlog::level::warn);
}

}  // namespace

OffingStatus fail(OffingStatus status, const char* error, const char* hint) noexcept {
  try {
    last_failure = {error, hint};
  } catch (const std::bad_alloc&) {
    last_failure = {};
  }
  return status;
}

OffingStatus status_of(ErrorKind kind) {
  switch (exit_code(kind)) {
    case 2:
      return OFFING_BAD_INPUT;
    case 3:
      return OFFING_NO_DEVICE;
    case 130:
      return OFFING_CANCELLED;
    default:
      return OFFING_FAILED;
  }
}

void log_to_stderr() {
  static std::once_flag is_done;
  std::call_once(is_done, [] {
    const std::shared_ptr<spdlog::logger> logger = spdlog::default_logger();
    if (logger != nullptr && logger->name().empty()) warnings_to_stderr();
  });
}

void require(const void* argument, const char* name) {
  if (argument != nullptr) return;
  throw Error(ErrorKind::bad_usage, fmt::format("{}: expected a pointer, got NULL", name),
              "pass what offing.h asks for");
}

void require_count(const char* name, std::size_t count, std::size_t expected) {
  if (count == expected) return;
  throw Error(ErrorKind::bad_usage, fmt::format("{}: expected {}, got {}", name, expected, count),
              "offing.h says how many values an array has");
}

}  // namespace offing::c

const char* offing_version(void) {
  static const std::string version(offing::scene::version());
  return version.c_str();
}

int offing_interface(void) {
  return OFFING_INTERFACE;
}

const char* offing_last_error(void) {
  return offing::c::last_failure.error.c_str();
}

const char* offing_last_hint(void) {
  return offing::c::last_failure.hint.c_str();
}

OffingStatus offing_set_log(OffingLog log, void* user) {
  return offing::c::run([&] {
    if (log == nullptr) return offing::c::warnings_to_stderr();
    auto logger =
        std::make_shared<spdlog::logger>("offing", std::make_shared<offing::c::CallbackSink>(log, user));
    logger->set_level(spdlog::level::debug);
    spdlog::set_default_logger(std::move(logger));
  });
}
