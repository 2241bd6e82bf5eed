#include "host/base/unfinished_file.h"

#include <array>
#include <atomic>

#include <unistd.h>

namespace offing {
namespace {

// A signal handler can take no lock: each slot is claimed, and given back, in one exchange.
constinit std::array<std::atomic<const char*>, 256> slots{};
static_assert(std::atomic<const char*>::is_always_lock_free);
constinit std::atomic<bool> is_ending{false};

void exchange_in_one_slot(const char* expected, const char* wanted) {
  for (std::atomic<const char*>& slot : slots) {
    const char* found = expected;
    if (slot.compare_exchange_strong(found, wanted)) break;
  }
  // The handler may be reading the path, which must stay until it ends the process.
  while (is_ending) pause();
}

}  // namespace

void mark_unfinished(const char* path) noexcept {
  exchange_in_one_slot(nullptr, path);
}

void unmark_unfinished(const char* path) noexcept {
  exchange_in_one_slot(path, nullptr);
}

void remove_unfinished_files() noexcept {
  is_ending = true;
  for (std::atomic<const char*>& slot : slots) {
    if (const char* path = slot.exchange(nullptr)) unlink(path);
  }
}

}  // namespace offing
