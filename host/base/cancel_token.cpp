#include "host/base/cancel_token.h"

#include "host/base/error.h"

namespace offing {

void CancelToken::throw_if_cancelled() const {
  if (cancelled())
    throw Error(ErrorKind::cancelled, "stopped at the user's request",
                "run the same command again to start over");
}

}  // namespace offing
