#pragma once

#include <bitset>
#include <cstddef>
#include <cstdint>

namespace platon {

/// Measures which numbered messages of the other side were lost.
class LossMeter {
 public:
  /// Messages over which the loss is measured.
  static constexpr std::size_t kWindow = 100;

  /// The message with this number has arrived, in any order and perhaps twice. Numbers go up by one, modulo 256. A
  /// number within the kWindow before the newest counts as late, any other as newer, so gaps must be shorter than 156.
  void received(std::uint8_t sequence);

  /// The newest number received; 0 before any.
  std::uint8_t newest() const { return newest_; }
  /// Per cent lost of the last kWindow messages, or of all since the first when these are fewer; 0 … 100.
  std::uint8_t lostPercent() const;

 private:
  std::bitset<kWindow> arrived_;  // bit i: the message i before the newest
  std::size_t known_ = 0;         // messages from the first to the newest, at most kWindow
  std::uint8_t newest_ = 0;
};

}  // namespace platon
