#include "host/base/work.h"

#include "host/base/error.h"

namespace offing {

void CancelToken::throw_if_cancelled(const char* hint) const {
  if (cancelled()) throw Error(ErrorKind::cancelled, "stopped at the user's request", hint);
}

}  // namespace offing
