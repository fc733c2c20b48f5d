#pragma once

#include <cstddef>
#include <deque>

#include "client/netcode/link_statistics.h"
#include "client/ui/font.h"
#include "client/ui/overlay.h"

namespace platon {

/// How the connection does: one sample a frame.
struct NetSample {
  LinkStatistics line;
  double aheadTicks = 0;          ///< how far the prediction is ahead of what is confirmed
  double correctionSubunits = 0;  ///< of the own player's prediction in this frame; 0 when it held
  double corrections = 0;         ///< of the whole session
  double lastCorrection = 0;      ///< subunits; 0 before the first
  double downBytesPerSecond = 0;
  double upBytesPerSecond = 0;
};

/// The last seconds of a connection as a picture.
class NetGraph {
 public:
  static constexpr std::size_t kSamples = 180;

  void add(const NetSample& sample);
  /// Corner panel; `width` of the virtual screen. Empty without samples.
  Overlay overlay(const Font& font, float width) const;

 private:
  std::deque<NetSample> samples_;  // oldest first
};

}  // namespace platon
