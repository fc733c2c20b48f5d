#pragma once

#include <string>
#include <utility>
#include <vector>

#include "client/play/match/embedded_server.h"

namespace platon {

/// A server that others on this machine can join, on a free port.
inline EmbeddedSettings onLoopback(std::vector<std::string> levels) {
  EmbeddedSettings settings;
  settings.levels = std::move(levels);
  settings.listens = true;
  settings.bind = "127.0.0.1";
  settings.port = 0;
  return settings;
}

}  // namespace platon
