#include "client/net/network_conditions.h"

#include <algorithm>
#include <utility>

namespace platon {

namespace {

constexpr double kMinRate = 0.001;

Moment milliseconds(double count) { return Moment(static_cast<Moment::rep>(count * 1000)); }

}  // namespace

bool LinkQuality::perfect() const {
  return lossPercent <= 0 && burstLossPercent <= 0 && delayMs <= 0 && jitterMs <= 0 && duplicatePercent <= 0 &&
         reorderPercent <= 0 && kilobytesPerSecond <= 0 && corruptPercent <= 0;
}

void NetworkConditions::send(std::vector<std::uint8_t> datagram, Moment now) {
  const std::optional<Moment> passed = passBottleneck(datagram.size(), now);
  if (!passed) return;
  // The burst state changes with each datagram, even if it is lost for another reason.
  const bool inBurst = drawBurst();
  if (chance(quality_.lossPercent) || inBurst) return;
  const Moment due = dueTime(*passed);
  if (chance(quality_.duplicatePercent)) deliverAt(datagram, due);
  deliverAt(std::move(datagram), due);
}

std::optional<Moment> NetworkConditions::passBottleneck(std::size_t bytes, Moment now) {
  if (quality_.kilobytesPerSecond <= 0) return now;
  const Moment turn = std::max(now, freeAt_);
  if (turn - now > kMaxQueueTime) return std::nullopt;
  freeAt_ = turn + milliseconds(static_cast<double>(bytes) / std::max(quality_.kilobytesPerSecond, kMinRate));
  return freeAt_;
}

bool NetworkConditions::drawBurst() {
  const double share = quality_.burstLossPercent / 100;
  if (share <= 0) return false;
  const double odds = share / (1 - share);
  const double length = std::max({quality_.burstLength, odds, 1.0});
  inBurst_ = draw() < (inBurst_ ? 1 - 1 / length : std::min(odds / std::max(quality_.burstLength, 1.0), 1.0));
  return inBurst_;
}

Moment NetworkConditions::dueTime(Moment now) {
  const Moment due = now + milliseconds(quality_.delayMs + draw() * quality_.jitterMs);
  if (chance(quality_.reorderPercent)) return due + kReorderDelay;
  lastDue_ = std::max(lastDue_, due);
  return lastDue_;
}

void NetworkConditions::deliverAt(std::vector<std::uint8_t> datagram, Moment due) {
  if (quality_.corruptPercent > 0 && chance(quality_.corruptPercent)) corrupt(datagram);
  const auto place = std::upper_bound(inFlight_.begin(), inFlight_.end(), due,
                                      [](Moment moment, const InFlight& other) { return moment < other.due; });
  inFlight_.insert(place, {due, std::move(datagram)});
}

void NetworkConditions::corrupt(std::vector<std::uint8_t>& datagram) {
  if (datagram.empty()) return;
  const std::uint64_t bit = random_() % (datagram.size() * 8);
  datagram[bit / 8] ^= static_cast<std::uint8_t>(1u << bit % 8);
}

std::optional<std::vector<std::uint8_t>> NetworkConditions::receive(Moment now) {
  if (inFlight_.empty() || inFlight_.front().due > now) return std::nullopt;
  std::vector<std::uint8_t> datagram = std::move(inFlight_.front().datagram);
  inFlight_.erase(inFlight_.begin());
  return datagram;
}

}  // namespace platon
