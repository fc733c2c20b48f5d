#pragma once

#include <random>

#include "client/ui/controls/bindings.h"
#include "client/ui/controls/key_names.h"

namespace platon {

inline Key randomKey(std::mt19937_64& random) {
  while (true) {
    const auto key = static_cast<Key>(random() % kKeyCount);
    if (canBeBound(key)) return key;
  }
}

inline Control randomControl(std::mt19937_64& random) { return static_cast<Control>(random() % kControlCount); }

/// Changes the bindings as a player may, `count` times.
inline void change(Bindings& bindings, std::mt19937_64& random, int count) {
  for (int i = 0; i < count; ++i) {
    if (random() % 8 == 0)
      bindings.clear(randomControl(random));
    else
      bindings.bind(randomControl(random), randomKey(random));
  }
}

}  // namespace platon
