#include "client/audio/audio.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <utility>

#include "client/audio/pads.h"

namespace platon {
namespace {

constexpr double kRollGain = 0.5;        // at full speed
constexpr double kRollSmoothing = 0.07;  // seconds in which the heard speed follows to 1/e

template <class Value>
bool isDone(const std::future<Value>& future) {
  return future.valid() && future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

}  // namespace

Audio::Audio(Open open)
    : loading_(std::async(std::launch::async, [this, open = std::move(open)] { return load(open); })) {}

Audio::~Audio() {
  stopped_ = true;
  if (loading_.valid()) loading_.wait();
}

Audio::Ready Audio::load(const Open& open) const {
  Ready ready;
  ready.output = open();
  if (ready.output == nullptr) return ready;
  for (const Sound sound : kAllSounds) {
    if (stopped_) return ready;
    ready.sounds[static_cast<std::size_t>(sound)] = ready.output->addBuffer(makeSound(sound));
  }
  ready.roll =
      ready.output->startLoop(ready.sounds[static_cast<std::size_t>(Sound::kRoll)], OpenalOutput::Group::kEffects);
  return ready;
}

bool Audio::isReady() {
  if (isDone(loading_)) {
    ready_ = loading_.get();
    if (ready_->output == nullptr) std::fprintf(stderr, "platon-client: no sound: there is no audio device\n");
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
  if (!pad) pad = Pad{std::async(std::launch::async, [solid] { return makePad(solid); })};
  return pad->loop.has_value();
}

void Audio::takePads() {
  for (std::optional<Pad>& pad : pads_) {
    if (!pad || !isDone(pad->making)) continue;
    const OpenalOutput::Buffer buffer = ready_->output->addBuffer(pad->making.get());
    pad->loop = ready_->output->startLoop(buffer, OpenalOutput::Group::kMusic);
  }
}

}  // namespace platon
