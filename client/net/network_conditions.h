#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <vector>

#include "client/time/moment.h"

namespace platon {

/// How bad one direction of a link is. All zero: perfect.
struct LinkQuality {
  double lossPercent = 0;         ///< datagrams lost, each on its own, 0 … 100
  double burstLossPercent = 0;    ///< datagrams lost in bursts, 0 … 100; those of lossPercent come on top
  double burstLength = 4;         ///< datagrams in a burst, on average, at least 1; see NetworkConditions
  double delayMs = 0;             ///< of every datagram, one way
  double jitterMs = 0;            ///< further delay, evenly between 0 and this; keeps the order
  double duplicatePercent = 0;    ///< datagrams delivered twice
  double reorderPercent = 0;      ///< datagrams held back for kReorderDelay, so that later ones overtake them
  double kilobytesPerSecond = 0;  ///< of UDP payload, 1000 bytes each, that pass at most; 0: no limit, else ≥ 0.001
  double corruptPercent = 0;      ///< datagrams of which one bit arrives flipped

  bool perfect() const;
};

/// One direction of a simulated link: datagrams go in, and come out late, twice, out of order, damaged or not at all.
/// The same seed, datagrams and times give the same deliveries everywhere. Bursts and corruption draw nothing while
/// their shares are 0.
///
/// Rate: a datagram of n bytes takes n / rate, one after another in the order in which they were sent, those included
/// that get lost further on. Who would wait for longer than kQueue until its turn is dropped at once; so never more
/// waits than passes in this time, and one datagram. Delay and jitter begin when a datagram has passed.
///
/// Bursts: the line is in one of two states, which may change before each datagram; within a burst all are lost
/// (Gilbert's model). With the share s that is to be lost, and the mean length L of a burst, a burst ends with
/// probability 1 / L and begins with s / (L (1 − s)). Then a share s of all datagrams falls into bursts. Where that
/// would need more than one burst after another, L < s / (1 − s), bursts are of this length.
///
/// Corruption: every copy on its own; of a datagram that comes twice one may be whole.
class NetworkConditions {
 public:
  static constexpr Moment kReorderDelay = std::chrono::milliseconds(40);
  static constexpr Moment kQueue = std::chrono::milliseconds(250);

  NetworkConditions(const LinkQuality& quality, std::uint64_t seed) : quality_(quality), random_(seed) {}

  /// A datagram is sent at `now`, which never decreases.
  void send(std::vector<std::uint8_t> datagram, Moment now);
  /// The next datagram that has arrived by `now`.
  std::optional<std::vector<std::uint8_t>> receive(Moment now);
  /// What is sent from now on has this quality.
  void setQuality(const LinkQuality& quality) { quality_ = quality; }
  /// Loses all that is on its way.
  void clear() { flying_.clear(); }
  /// Datagrams on their way.
  std::size_t pending() const { return flying_.size(); }

 private:
  struct Flying {
    Moment due;
    std::vector<std::uint8_t> datagram;
  };

  double draw() { return static_cast<double>(random_() >> 11) * 0x1p-53; }
  bool happens(double percent) { return draw() * 100 < percent; }
  std::optional<Moment> passBottleneck(std::size_t bytes, Moment now);
  bool isInBurst();
  Moment dueTime(Moment now);
  void launch(std::vector<std::uint8_t> datagram, Moment due);
  void corrupt(std::vector<std::uint8_t>& datagram);

  LinkQuality quality_;
  std::mt19937_64 random_;
  Moment freeAt_{};       // when all that waits for its turn has passed
  bool inBurst_ = false;  // at the last datagram
  Moment lastDue_{};
  std::vector<Flying> flying_;  // by due time, the first sent first among equals
};

}  // namespace platon
