#include "client/play/net_meter.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace platon {

NetSample NetMeter::sample(const NetworkClient& client, Moment now) {
  const Traffic traffic = client.traffic();
  readings_.push_back({now, traffic});
  while (now - readings_.front().at > std::chrono::seconds(1)) readings_.pop_front();
  const Reading& then = readings_.front();
  const Traffic gained = traffic - then.traffic;
  const double seconds = std::max(toSeconds(now - then.at), 1e-3);

  NetSample sample;
  sample.link = client.session()->reading();
  sample.downBytesPerSecond = static_cast<double>(gained.receivedBytes) / seconds;
  sample.upBytesPerSecond = static_cast<double>(gained.sentBytes) / seconds;
  const PredictionStatistics count = client.session()->predictionStatistics();
  if (std::exchange(corrections_, count.corrections) != count.corrections) {
    sample.correctionSubunits = count.lastSubunits;
  }
  sample.corrections = count.corrections;
  sample.lastCorrection = count.lastSubunits;
  if (const Round* const round = client.session()->round()) {
    const Prediction& prediction = round->prediction();
    sample.aheadTicks = double{1} * prediction.predictedTicks() - prediction.confirmedTicks();
  }
  return sample;
}

}  // namespace platon
