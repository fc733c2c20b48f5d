#include "client/play/match/session_feeds.h"

#include <algorithm>
#include <chrono>
#include <span>
#include <utility>

namespace platon {

namespace {

// A local player between the last two predicted ticks; at the last one if it was absent in the one before.
InterpolatedPlayer predictedPlayer(const Round& round, std::uint32_t slot) {
  const Prediction& prediction = round.prediction();
  const std::span<const EntityState> before = prediction.predictedBefore();
  InterpolatedPlayer local;
  local.now = local.before = snapshotOf(prediction.predicted(), slot);
  local.fraction = round.predictedFraction();
  if (slot < before.size() && before[slot].inserted != 0) local.before = snapshotOf(before[slot]);
  return local;
}

// All local players but the one with this local number.
std::vector<CompanionSource> companionsOf(const Round& round, std::size_t local, Time now) {
  std::vector<CompanionSource> companions;
  const Prediction& prediction = round.prediction();
  for (std::size_t i = 0; i < prediction.slots().size(); ++i) {
    const std::optional<std::uint32_t>& slot = prediction.slots()[i];
    if (slot && i != local) companions.push_back({*slot, predictedPlayer(round, *slot), prediction.smoothing(i, now)});
  }
  return companions;
}

// The last source of the session's round; nothing without a round.
std::optional<CueSource> sourceOf(const Session* session, const Scene* scene, std::optional<double> nextRoundSeconds) {
  if (session == nullptr || session->round() == nullptr || scene == nullptr) return std::nullopt;
  const Round& round = *session->round();
  const Prediction& prediction = round.prediction();
  CueSource source;
  source.round = round.id();
  source.mesh = &scene->stage->mesh;
  source.predicted = &prediction.predicted();
  source.predictedTicks = prediction.predictedTicks();
  source.confirmed = &prediction.confirmed();
  source.confirmedTicks = prediction.confirmedTicks();
  source.othersTick = round.interpolationBuffer().tick();
  source.localSlot = prediction.slot();
  for (std::size_t local = 1; local < prediction.slots().size(); ++local)
    if (prediction.slots()[local]) source.companions.push_back(*prediction.slots()[local]);
  source.over = scene->over;
  source.timed = scene->timed;
  source.nextRoundSeconds = nextRoundSeconds;
  return source;
}

}  // namespace

// Each player's flash at the tick at which the player is drawn.
void SceneFeed::updateFlashes(const Round& round) {
  const Prediction& prediction = round.prediction();
  const double localTick = double{1} * prediction.predictedTicks() - 1 + round.predictedFraction();
  flashes_.assign(prediction.predicted().slots(), 0);
  for (std::uint32_t slot = 0; slot < flashes_.size(); ++slot) {
    flashes_[slot] =
        round.flashes().brightness(slot, prediction.isLocal(slot) ? localTick : round.interpolationBuffer().tick());
  }
}

void SceneFeed::updateRoundTrips(const Session& session, Time now) {
  roundTrips_.resize(session.names().size());
  for (std::uint32_t slot = 0; slot < roundTrips_.size(); ++slot) roundTrips_[slot] = session.roundTripMs(slot, now);
}

std::optional<Scene> SceneFeed::scene(const Session& session, Time now, SceneExtras extras) {
  const Round* const round = session.round();
  if (round == nullptr) return std::nullopt;
  const Prediction& prediction = round->prediction();
  if (prediction.confirmed().sharedLevel() != level_) {
    level_ = prediction.confirmed().sharedLevel();
    stage_ = makeStageModel(*level_);
  }
  SceneSource source;
  source.stage = stage_;
  source.game = &prediction.predicted();
  source.roundOver = session.roundEnd() != nullptr;
  source.timed = extras.timed;
  source.fraction = round->predictedFraction();
  source.others = round->interpolationBuffer().players();
  const std::size_t local = extras.local;
  source.localSlot = prediction.slots()[local];
  source.local = predictedPlayer(*round, *source.localSlot);
  source.localOffset = prediction.smoothing(local, now);
  source.companions = companionsOf(*round, local, now);
  source.names = session.names();
  updateRoundTrips(session, now);
  source.roundTrips = roundTrips_;
  updateFlashes(*round);
  source.flashes = flashes_;
  source.attempt = round->attemptTime(local);
  source.team = round->teamTime();
  source.needsRestart = round->endlessFall(local).needsHint();
  source.longFall = round->endlessFall(local).isLong();
  source.othersCanJoin = true;
  source.ghosts = std::move(extras.ghosts);
  for (std::size_t i = 0; i < extras.balls.size(); ++i)
    if (prediction.slots()[i]) source.ownBalls.push_back({*prediction.slots()[i], extras.balls[i]});
  return makeScene(source);
}

void SoundFeed::menu(Menu::Feedback feedback) {
  if (feedback == Menu::Feedback::kNone) return;
  audio_.play(feedback == Menu::Feedback::kMoved ? Sound::kMenuMove : Sound::kMenuChoose);
}

void SoundFeed::update(const Session* session, const Scene* scene, std::optional<double> nextRoundSeconds,
                       const Settings& settings, double seconds) {
  const std::optional<CueSource> source = sourceOf(session, scene, nextRoundSeconds);
  audio_.update(cues_.update(source ? &*source : nullptr),
                {settings.volume, settings.effectsVolume, settings.musicVolume}, seconds);
}

NetSample NetMeter::sample(const NetworkClient& client, Time now) {
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
