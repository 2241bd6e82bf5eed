#include "host/c/call.h"

#include <memory>
#include <mutex>
#include <utility>

#include <spdlog/sinks/base_sink.h>
#include <spdlog/sinks/stdout_color_sinks.h>

#include "host/base/log.h"
#include "host/scene/file/version.h"

namespace offing::c {
namespace {

struct LastFailure {
  std::string error, hint;
};
thread_local LastFailure last_failure;

/// Hands each line to the program or, without a callback, warnings and errors to stderr. It stays while the
/// process lives, so that threads may log while the callback changes.
class ProgramSink : public spdlog::sinks::base_sink<std::mutex> {
 public:
  ProgramSink() { stderr_.set_pattern("%^%l%$: %v"); }

  void set(OffingLog log, void* user) {
    const std::lock_guard lock(mutex_);
    log_ = log;
    user_ = user;
  }

 protected:
  void sink_it_(const spdlog::details::log_msg& message) override {
    if (log_ != nullptr) {
      const std::string line(message.payload.data(), message.payload.size());
      log_(user_, level_of(message.level), line.c_str());
    } else if (message.level >= spdlog::level::warn) {
      stderr_.log(message);
    }
  }
  void flush_() override {}

 private:
  static OffingLogLevel level_of(spdlog::level::level_enum level) {
    if (level >= spdlog::level::err) return OFFING_LOG_ERROR;
    if (level == spdlog::level::warn) return OFFING_LOG_WARNING;
    return level == spdlog::level::info ? OFFING_LOG_INFO : OFFING_LOG_DEBUG;
  }

  spdlog::sinks::stderr_color_sink_mt stderr_;
  OffingLog log_ = nullptr;
  void* user_ = nullptr;
};

struct ProgramLog {
  std::shared_ptr<ProgramSink> sink = std::make_shared<ProgramSink>();
  std::shared_ptr<spdlog::logger> logger = std::make_shared<spdlog::logger>("offing", sink);
};

const ProgramLog& program_log() {
  static const ProgramLog log;
  return log;
}

/// Lines below warnings are for callbacks alone.
void use_program_log(OffingLog log, void* user) {
  const auto& [sink, logger] = program_log();
  sink->set(log, user);
  logger->set_level(log == nullptr ? spdlog::level::warn : spdlog::level::debug);
  if (spdlog::default_logger() != logger) spdlog::set_default_logger(logger);
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
    if (logger != nullptr && logger->name().empty()) use_program_log(nullptr, nullptr);
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
  return offing::c::run([&] { offing::c::use_program_log(log, user); });
}
