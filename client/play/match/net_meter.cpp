#include "client/play/match/net_meter.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace platon {

NetSample NetMeter::sample(const NetworkClient& client, Moment now) {
  const Traffic traffic = client.traffic();
  readings_.push_back({now, traffic});
  while (now - readings_.front().at > std::chrono::seconds(1)) readings_.pop_front();
  const Reading& oldest = readings_.front();
  const Traffic recent = traffic - oldest.traffic;
  const double seconds = std::max(toSeconds(now - oldest.at), 1e-3);

  NetSample sample;
  sample.link = client.session()->linkStatistics();
  sample.downBytesPerSecond = static_cast<double>(recent.receivedBytes) / seconds;
  sample.upBytesPerSecond = static_cast<double>(recent.sentBytes) / seconds;
  sample.framesPerSecond = static_cast<double>(readings_.size() - 1) / seconds;
  const PredictionStatistics prediction = client.session()->predictionStatistics();
  if (std::exchange(corrections_, prediction.corrections) != prediction.corrections) {
    sample.correctionSubunits = prediction.lastSubunits;
  }
  sample.corrections = prediction.corrections;
  sample.lastCorrection = prediction.lastSubunits;
  if (const Round* const round = client.session()->round()) {
    sample.aheadTicks = double{1} * round->prediction().predictedTicks() - round->prediction().confirmedTicks();
  }
  return sample;
}

}  // namespace platon
