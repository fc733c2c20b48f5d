#pragma once

#include <cstdint>

#include "platon/game/element.h"

namespace platon {

/// A word of the kind, with `number` where one number follows. A timed segment is solid for one tick more than that,
/// and open for 30.
inline ElementWord sampleWord(ElementKind kind, std::uint16_t number = 2) {
  switch (numbersOf(kind)) {
    case 0:
      return {kind, 0, 0};
    case 1:
      return {kind, number, 0};
    default:
      return {kind, static_cast<std::uint16_t>(number + 1), 30};
  }
}

}  // namespace platon
