#pragma once

#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <variant>

#include "client/replay/replay.h"

namespace platon {

/// The replay of a recording. Throws std::invalid_argument if it cannot be played.
inline std::shared_ptr<const Replay> replayOf(std::span<const std::uint8_t> recording) {
  auto read = Replay::read(recording);
  if (const auto* fault = std::get_if<std::string>(&read)) throw std::invalid_argument(*fault);
  return std::get<std::shared_ptr<const Replay>>(read);
}

}  // namespace platon
