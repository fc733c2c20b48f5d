#include "client/network_conditions.h"

#include <algorithm>
#include <utility>

namespace platon {

namespace {

Moment milliseconds(double count) { return Moment(static_cast<Moment::rep>(count * 1000)); }

}  // namespace

bool LinkQuality::perfect() const {
  return lossPercent <= 0 && delayMs <= 0 && jitterMs <= 0 && duplicatePercent <= 0 && reorderPercent <= 0;
}

void NetworkConditions::send(std::vector<std::uint8_t> datagram, Moment now) {
  if (happens(quality_.lossPercent)) return;
  const Moment due = dueTime(now);
  if (happens(quality_.duplicatePercent)) launch(datagram, due);
  launch(std::move(datagram), due);
}

Moment NetworkConditions::dueTime(Moment now) {
  const Moment due = now + milliseconds(quality_.delayMs + draw() * quality_.jitterMs);
  if (happens(quality_.reorderPercent)) return due + kReorderDelay;
  lastDue_ = std::max(lastDue_, due);
  return lastDue_;
}

void NetworkConditions::launch(std::vector<std::uint8_t> datagram, Moment due) {
  const auto place = std::upper_bound(flying_.begin(), flying_.end(), due,
                                      [](Moment moment, const Flying& other) { return moment < other.due; });
  flying_.insert(place, {due, std::move(datagram)});
}

std::optional<std::vector<std::uint8_t>> NetworkConditions::receive(Moment now) {
  if (flying_.empty() || flying_.front().due > now) return std::nullopt;
  std::vector<std::uint8_t> datagram = std::move(flying_.front().datagram);
  flying_.erase(flying_.begin());
  return datagram;
}

}  // namespace platon
