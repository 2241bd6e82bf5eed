#include "host/base/freed_memory.h"

#include <cstdlib>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace offing {

// By itself glibc gives back what lies at the end of its heap, and arrays that were large enough for pages of
// their own when they were allocated. The first such array that is freed raises that size, up to 32 MiB, so
// that from then on most arrays lie in the heap, where any small block behind them keeps them. After a pass
// through 30 scenes a window of the first one held 551 MB so, and 352 MB once they were given back; what was
// in use stayed the same from pass to pass.
void give_back_freed_memory() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

void keep_large_arrays_apart() {
#ifdef __GLIBC__
  constexpr int mebibyte = 1 << 20;
  mallopt(M_MMAP_THRESHOLD, mebibyte);  // which also ends that the threshold grows by itself
#endif
}

}  // namespace offing
