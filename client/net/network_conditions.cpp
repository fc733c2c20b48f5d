#include "client/net/network_conditions.h"

#include <algorithm>
#include <utility>

namespace platon {

namespace {

constexpr double kSlowestRate = 0.001;

Moment milliseconds(double count) { return Moment(static_cast<Moment::rep>(count * 1000)); }

}  // namespace

bool LinkQuality::perfect() const {
  return lossPercent <= 0 && burstLossPercent <= 0 && delayMs <= 0 && jitterMs <= 0 && duplicatePercent <= 0 &&
         reorderPercent <= 0 && kilobytesPerSecond <= 0 && corruptPercent <= 0;
}

void NetworkConditions::send(std::vector<std::uint8_t> datagram, Moment now) {
  const std::optional<Moment> passed = passBottleneck(datagram.size(), now);
  if (!passed) return;
  const bool inBurst = isInBurst();  // bursts go on, whatever else is lost
  if (happens(quality_.lossPercent) || inBurst) return;
  const Moment due = dueTime(*passed);
  if (happens(quality_.duplicatePercent)) launch(datagram, due);
  launch(std::move(datagram), due);
}

std::optional<Moment> NetworkConditions::passBottleneck(std::size_t bytes, Moment now) {
  if (quality_.kilobytesPerSecond <= 0) return now;
  const Moment turn = std::max(now, freeAt_);
  if (turn - now > kQueue) return std::nullopt;
  freeAt_ = turn + milliseconds(static_cast<double>(bytes) / std::max(quality_.kilobytesPerSecond, kSlowestRate));
  return freeAt_;
}

bool NetworkConditions::isInBurst() {
  const double share = quality_.burstLossPercent / 100;
  if (share <= 0) return false;
  const double odds = share / (1 - share);
  const double length = std::max({quality_.burstLength, odds, 1.0});
  inBurst_ = draw() < (inBurst_ ? 1 - 1 / length : std::min(odds / std::max(quality_.burstLength, 1.0), 1.0));
  return inBurst_;
}

Moment NetworkConditions::dueTime(Moment now) {
  const Moment due = now + milliseconds(quality_.delayMs + draw() * quality_.jitterMs);
  if (happens(quality_.reorderPercent)) return due + kReorderDelay;
  lastDue_ = std::max(lastDue_, due);
  return lastDue_;
}

void NetworkConditions::launch(std::vector<std::uint8_t> datagram, Moment due) {
  if (quality_.corruptPercent > 0 && happens(quality_.corruptPercent)) corrupt(datagram);
  const auto place = std::upper_bound(flying_.begin(), flying_.end(), due,
                                      [](Moment moment, const Flying& other) { return moment < other.due; });
  flying_.insert(place, {due, std::move(datagram)});
}

void NetworkConditions::corrupt(std::vector<std::uint8_t>& datagram) {
  if (datagram.empty()) return;
  const std::uint64_t bit = random_() % (datagram.size() * 8);
  datagram[bit / 8] ^= static_cast<std::uint8_t>(1u << bit % 8);
}

std::optional<std::vector<std::uint8_t>> NetworkConditions::receive(Moment now) {
  if (flying_.empty() || flying_.front().due > now) return std::nullopt;
  std::vector<std::uint8_t> datagram = std::move(flying_.front().datagram);
  flying_.erase(flying_.begin());
  return datagram;
}

}  // namespace platon
