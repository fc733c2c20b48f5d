#pragma once

#include <cstdint>
#include <memory>

#include "client/bot/button_presser.h"
#include "client/session/round.h"

namespace platon {

/// Buttons as a person presses them, another way for every seed.
inline Controls pressing(std::uint64_t seed) {
  return [presser = std::make_shared<ButtonPresser>(seed)](const Game&, std::uint32_t) { return presser->next(); };
}

}  // namespace platon
