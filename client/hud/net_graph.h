#pragma once

#include <cstddef>
#include <deque>

#include "client/netcode/link_meter.h"
#include "client/ui/font.h"
#include "client/ui/overlay.h"

namespace platon {

/// Link statistics of one frame.
struct NetSample {
  LinkStatistics link;
  double aheadTicks = 0;          ///< predicted ticks that are not confirmed yet
  double correctionSubunits = 0;  ///< correction of the local player in this frame; 0 if none
  double corrections = 0;         ///< number in this session
  double lastCorrection = 0;      ///< size of the last correction, subunits; 0 before the first
  double downBytesPerSecond = 0;
  double upBytesPerSecond = 0;
  double framesPerSecond = 0;  ///< drawn, over the last second
};

/// Graph of the round trip and the corrections of the last frames, with the latest link statistics.
class NetGraph {
 public:
  static constexpr std::size_t kSamples = 180;

  void add(const NetSample& sample);
  /// A panel in the lower right corner; empty without samples. `width` is that of the virtual screen.
  Overlay overlay(const Font& font, float width) const;

 private:
  std::deque<NetSample> samples_;  // oldest first
};

}  // namespace platon
