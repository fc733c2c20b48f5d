#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <vector>

#include "client/moment.h"

namespace platon {

/// How bad one direction of a link is. All zero: perfect.
struct LinkQuality {
  double lossPercent = 0;        ///< datagrams lost, 0 … 100
  double delayMs = 0;            ///< of every datagram, one way
  double jitterMs = 0;           ///< further delay, evenly between 0 and this; keeps the order
  double duplicatePercent = 0;   ///< datagrams delivered twice
  double reorderPercent = 0;     ///< datagrams held back for kReorderDelay, so that later ones overtake them

  bool perfect() const;
};

/// One direction of a simulated link: datagrams go in, and come out late, twice, out of order or not at all. The same
/// seed, datagrams and times give the same deliveries everywhere.
class NetworkConditions {
 public:
  static constexpr Moment kReorderDelay = std::chrono::milliseconds(40);

  NetworkConditions(const LinkQuality& quality, std::uint64_t seed) : quality_(quality), random_(seed) {}

  /// A datagram is sent at `now`, which never decreases.
  void send(std::vector<std::uint8_t> datagram, Moment now);
  /// The next datagram that has arrived by `now`.
  std::optional<std::vector<std::uint8_t>> receive(Moment now);
  /// Datagrams on their way.
  std::size_t pending() const { return flying_.size(); }

 private:
  struct Flying {
    Moment due;
    std::vector<std::uint8_t> datagram;
  };

  double draw() { return static_cast<double>(random_() >> 11) * 0x1p-53; }
  bool happens(double percent) { return draw() * 100 < percent; }
  Moment dueTime(Moment now);
  void launch(std::vector<std::uint8_t> datagram, Moment due);

  LinkQuality quality_;
  std::mt19937_64 random_;
  Moment lastDue_{};
  std::vector<Flying> flying_;   // by due time, the first sent first among equals
};

}  // namespace platon
