#include "client/audio/audio.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

#include "client/audio/pads.h"

namespace platon {
namespace {

constexpr double kRollGain = 0.5;        // at full speed
constexpr double kRollSmoothing = 0.07;  // seconds in which the heard speed follows to 1/e

}  // namespace

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
  takePads();
  fade_.advance(frame.solid && hasPad(*frame.solid) ? frame.solid : std::nullopt, seconds);
  for (std::size_t i = 0; i < pads_.size(); ++i) {
    if (!pads_[i] || !pads_[i]->loop) continue;
    ready_->output->setLoop(*pads_[i]->loop, fade_.gain(static_cast<SolidKind>(i)), 1);
  }
}

// Whether the pad can be heard. The first time, starts to make it.
bool Audio::hasPad(SolidKind solid) {
  std::optional<Pad>& pad = pads_[static_cast<std::size_t>(solid)];
  if (!pad) pad.emplace().making.add([solid](const std::stop_token&) { return makePad(solid); });
  return pad->loop.has_value();
}

void Audio::takePads() {
  for (std::optional<Pad>& pad : pads_) {
    const std::optional<JobResult<Pcm>> made = pad ? pad->making.poll() : std::nullopt;
    if (!made || !made->value) continue;  // without memory for it, there is no music
    const OpenalOutput::Buffer buffer = ready_->output->addBuffer(*made->value);
    pad->loop = ready_->output->startLoop(buffer, OpenalOutput::Group::kMusic);
  }
}

}  // namespace platon
