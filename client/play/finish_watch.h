#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "client/session/session.h"

namespace platon {

/// Notices when the own player finishes a level.
class FinishWatch {
 public:
  /// `finished LEVEL in S s`, once for every round in which the server has confirmed it; else nothing.
  std::optional<std::string> look(const Session& session);

 private:
  std::optional<std::pair<std::uint32_t, std::uint32_t>> reported_;  // round and tick: a server that was started anew
                                                                     // counts its rounds anew
};

}  // namespace platon
