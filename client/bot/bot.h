#pragma once

#include <optional>

#include "client/bot/bot_measure.h"
#include "client/desync/desync_report.h"
#include "protocol/moment.h"

namespace platon {

/// A headless client that presses buttons at random.
class Bot {
 public:
  Bot() = default;
  virtual ~Bot() = default;
  Bot(const Bot&) = delete;
  Bot& operator=(const Bot&) = delete;

  /// Call every few milliseconds.
  virtual void update(Moment now) = 0;
  virtual void leave() = 0;
  virtual std::optional<DesyncReport> takeDesync() { return std::nullopt; }
  virtual bool closed() const = 0;
  virtual BotResult result() const = 0;
};

}  // namespace platon
