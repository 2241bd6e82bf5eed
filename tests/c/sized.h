#pragma once

namespace offing {

/// A struct of offing.h whose members are zero, but for its size.
template <class Struct>
Struct sized() {
  Struct zeros{};
  zeros.size = sizeof zeros;
  return zeros;
}

}  // namespace offing
