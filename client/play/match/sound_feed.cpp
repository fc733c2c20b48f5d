#include "client/play/match/sound_feed.h"

#include <optional>

namespace platon {
namespace {

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
  source.over = scene->over;
  source.timed = scene->timed;
  source.nextRoundSeconds = nextRoundSeconds;
  return source;
}

}  // namespace

void SoundFeed::menu(Menu::Deed deed) {
  if (deed != Menu::Deed::kNone) audio_.play(deed == Menu::Deed::kMoved ? Sound::kMenuMove : Sound::kMenuChoose);
}

void SoundFeed::update(const Session* session, const Scene* scene, std::optional<double> nextRoundSeconds,
                       const Settings& settings, double seconds) {
  const std::optional<CueSource> source = sourceOf(session, scene, nextRoundSeconds);
  audio_.update(cues_.update(source ? &*source : nullptr),
                {settings.volume, settings.effectsVolume, settings.musicVolume}, seconds);
}

}  // namespace platon
