#pragma once

#include <bitset>
#include <cstddef>
#include <cstdint>

namespace platon {

/// Which of the numbered messages of the other side were lost.
class LossMeter {
 public:
  /// Messages that are looked back on.
  static constexpr std::size_t kWindow = 100;

  /// The message with this number has arrived, in any order, perhaps for the second time. Numbers go up by one, modulo
  /// 256. One of the kWindow up to the newest is taken to come late; so a gap must be shorter than 156.
  void heard(std::uint8_t sequence);

  /// The newest number heard; 0 before any.
  std::uint8_t newest() const { return newest_; }
  /// Of the last kWindow messages up to the newest, or of those since the first; 0 … 100.
  std::uint8_t lostPercent() const;

 private:
  std::bitset<kWindow> arrived_;  // [i]: the i-th before the newest
  std::size_t known_ = 0;         // messages from the first to the newest, at most kWindow
  std::uint8_t newest_ = 0;
};

}  // namespace platon
