#include "client/play/sound_feed.h"

#include <optional>

namespace platon {
namespace {

std::optional<Sound> menuSoundOf(Key key) {
  switch (key) {
    case Key::kArrowUp:
    case Key::kArrowDown:
    case Key::kArrowLeft:
    case Key::kArrowRight:
    case Key::kPadUp:
    case Key::kPadDown:
    case Key::kPadLeft:
    case Key::kPadRight:
      return Sound::kMenuMove;
    case Key::kSpace:
    case Key::kEnter:
    case Key::kEscape:
    case Key::kPadA:
    case Key::kPadB:
    case Key::kPadStart:
      return Sound::kMenuChoose;
    default:
      return std::nullopt;
  }
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
  source.over = session->roundEnd() != nullptr || prediction.predicted().over();
  source.timed = scene->timed;
  source.nextRoundSeconds = nextRoundSeconds;
  return source;
}

}  // namespace

void SoundFeed::key(const KeyEvent& event, bool menuOpen) {
  const std::optional<Sound> sound = menuOpen ? menuSoundOf(event.key) : std::nullopt;
  const bool isKey = event.kind == KeyEvent::Kind::kPress || event.kind == KeyEvent::Kind::kRepeat;
  if (sound && isKey) audio_.play(*sound);
}

void SoundFeed::update(const Session* session, const Scene* scene, std::optional<double> nextRoundSeconds,
                       const Settings& settings, double seconds) {
  const std::optional<CueSource> source = sourceOf(session, scene, nextRoundSeconds);
  audio_.update(cues_.update(source ? &*source : nullptr),
                {settings.volume, settings.effectsVolume, settings.musicVolume}, seconds);
}

}  // namespace platon
