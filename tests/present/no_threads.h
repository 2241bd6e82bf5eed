#pragma once

#include <cstddef>
#include <limits>

#include <pthread.h>

namespace offing::test {

/// A machine that gives no more threads, while this exists: each asks for a stack larger than any memory.
class NoThreads {
 public:
  NoThreads() {
    pthread_getattr_default_np(&before_);
    pthread_attr_t endless = before_;
    pthread_attr_setstacksize(&endless, std::numeric_limits<std::size_t>::max() / 4);
    pthread_setattr_default_np(&endless);
  }
  NoThreads(const NoThreads&) = delete;
  NoThreads& operator=(const NoThreads&) = delete;
  ~NoThreads() { pthread_setattr_default_np(&before_); }

 private:
  pthread_attr_t before_{};
};

}  // namespace offing::test
