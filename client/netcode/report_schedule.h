#pragma once

#include <cstdint>
#include <optional>

#include "client/time/moment.h"
#include "platon/game/input.h"

namespace platon {

/// When a client tells the server of its inputs: at once when they have changed, and twice more, a tick and two ticks
/// later; else every fourth tick. While there are none, every 80 ms.
class ReportSchedule {
 public:
  /// The input for the next tick is this.
  void chose(Input input);
  /// Something else has to be told at once.
  void hurry() { hurried_ = true; }

  /// Whether to tell of the inputs for the ticks before `ticks` now.
  bool due(Moment now, std::uint32_t ticks) const;
  /// They have been told.
  void told(Moment now, std::uint32_t ticks);

 private:
  std::optional<Moment> toldAt_;
  std::uint32_t toldTicks_ = 0;
  Input last_;                 // chosen
  bool chosen_ = false;        // an input since it was told last
  bool changed_ = false;       // and another than the one before
  std::uint32_t repeats_ = 0;  // of the last change, still to be told
  bool hurried_ = false;
};

}  // namespace platon
