#include "client/audio/audio.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <utility>

#include "client/audio/music.h"

namespace platon {
namespace {

constexpr double kRollGain = 0.5;        // at full speed
constexpr double kRollSmoothing = 0.07;  // seconds in which the heard speed follows to 1/e

}  // namespace

void MusicFade::advance(std::optional<SolidKind> solid, double seconds) {
  const double step = seconds / kFadeSeconds;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const bool heard = solid && static_cast<std::size_t>(*solid) == i;
    parts_[i] = std::clamp(parts_[i] + (heard ? step : -step), 0.0, 1.0);
  }
  const double range = 1 - kDuckGain;
  duckGain_ += duckLeft_ > 0 ? -range * seconds / kAttackSeconds : range * seconds / kReleaseSeconds;
  duckGain_ = std::clamp(duckGain_, kDuckGain, 1.0);
  duckLeft_ = std::max(0.0, duckLeft_ - seconds);
}

double MusicFade::gain(SolidKind solid) const {
  return duckGain_ * std::sin(parts_[static_cast<std::size_t>(solid)] * std::numbers::pi / 2);
}

Audio::Audio(Open open) {
  loading_.add([open = std::move(open)](const std::stop_token& stop) { return load(open, stop); });
}

Audio::Ready Audio::load(const Open& open, const std::stop_token& stop) {
  Ready ready;
  ready.output = open();
  if (ready.output == nullptr) return ready;
  for (const Sound sound : kAllSounds) {
    if (stop.stop_requested()) return ready;
    ready.sounds[static_cast<std::size_t>(sound)] = ready.output->addBuffer(makeSound(sound));
  }
  ready.roll =
      ready.output->startLoop(ready.sounds[static_cast<std::size_t>(Sound::kRoll)], OpenalOutput::Group::kEffects);
  return ready;
}

bool Audio::isReady() {
  if (auto loaded = loading_.poll()) {
    const std::string fault = loaded->value ? "there is no audio device" : loaded->fault;
    ready_ = loaded->value ? std::move(*loaded->value) : Ready();
    if (ready_->output == nullptr) std::fprintf(stderr, "platon-client: no sound: %s\n", fault.c_str());
  }
  return output() != nullptr;
}

void Audio::update(const SoundFrame& frame, const Volumes& volumes, double seconds) {
  if (!isReady()) return;
  OpenalOutput& out = *ready_->output;
  out.setGain(gainOf(volumes.all));
  out.setGain(OpenalOutput::Group::kEffects, gainOf(volumes.effects));
  out.setGain(OpenalOutput::Group::kMusic, gainOf(volumes.music));
  for (const Cue& cue : frame.cues) play(cue);
  updateRoll(frame.roll, seconds);
  updateMusic(frame, seconds);
}

void Audio::play(Sound sound) {
  if (isReady()) play(Cue{.sound = sound});
}

void Audio::play(const Cue& cue) {
  ready_->output->play(ready_->sounds[static_cast<std::size_t>(cue.sound)], cue.gain, cue.pan, cue.pitch);
}

void Audio::updateRoll(double speed, double seconds) {
  roll_ += (speed - roll_) * (1 - std::exp(-seconds / kRollSmoothing));
  ready_->output->setLoop(ready_->roll, kRollGain * roll_ * std::sqrt(roll_), 0.7 + 0.5 * roll_);
}

void Audio::updateMusic(const SoundFrame& frame, double seconds) {
  if (frame.celebrates) fade_.duck();
  takeMusic();
  fade_.advance(frame.solid && hasMusic(*frame.solid) ? frame.solid : std::nullopt, seconds);
  for (std::size_t i = 0; i < music_.size(); ++i) {
    if (!music_[i] || !music_[i]->loop) continue;
    ready_->output->setLoop(*music_[i]->loop, fade_.gain(static_cast<SolidKind>(i)), 1);
  }
}

// Whether the music of the solid can be heard. The first time, starts to make it.
bool Audio::hasMusic(SolidKind solid) {
  std::optional<Music>& music = music_[static_cast<std::size_t>(solid)];
  if (!music) music.emplace().making.add([solid](const std::stop_token&) { return makeMusic(solid); });
  return music->loop.has_value();
}

void Audio::takeMusic() {
  for (std::optional<Music>& music : music_) {
    const std::optional<JobResult<Pcm>> made = music ? music->making.poll() : std::nullopt;
    if (!made || !made->value) continue;  // without memory for it, there is no music
    const OpenalOutput::Buffer buffer = ready_->output->addBuffer(*made->value);
    music->loop = ready_->output->startLoop(buffer, OpenalOutput::Group::kMusic);
  }
}

}  // namespace platon
