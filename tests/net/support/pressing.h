#pragma once

#include <cstdint>
#include <memory>

#include "client/bot/button_presser.h"
#include "client/session/round.h"

namespace platon {

/// Controls that press random buttons.
inline Controls pressing(std::uint64_t seed) {
  return [presser = std::make_shared<ButtonPresser>(seed)](const Game&, std::uint32_t) { return presser->next(); };
}

}  // namespace platon
