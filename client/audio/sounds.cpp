#include "client/audio/sounds.h"

#include <cmath>
#include <span>

#include "client/audio/wave.h"

namespace platon {
namespace {

constexpr double kD4 = 293.665;

// A part of a chime: a sine with soft overtones that die away sooner.
void addBell(Wave& wave, double start, double frequency, double level, double decay) {
  const double seconds = decay * 5;
  wave.add(Tone{.start = start, .frequency = frequency, .level = level, .decay = decay, .seconds = seconds});
  wave.add(
      Tone{.start = start, .frequency = frequency * 2, .level = level * 0.22, .decay = decay / 2, .seconds = seconds});
  wave.add(Tone{
      .start = start, .frequency = frequency * 3.01, .level = level * 0.07, .decay = decay / 4, .seconds = seconds});
}

// Notes one after the other, `gap` seconds apart.
void addNotes(Wave& wave, std::initializer_list<int> steps, double gap, double decay) {
  double start = 0;
  for (const int step : steps) {
    addBell(wave, start, pentatonic(step), 1, decay);
    start += gap;
  }
}

// A bell sound that rings out in soft echoes.
Pcm chime(std::initializer_list<int> steps, double gap, double decay, double seconds, double peak) {
  Wave wave(seconds, Wave::Shape::kOnce);
  addNotes(wave, steps, gap, decay);
  wave.echo(0.19, 0.35, 3);
  return finishOnce(wave, peak);
}

Pcm roll() {
  Wave wave(3, Wave::Shape::kLoop);
  wave.addBreath(170, 1, 7);
  wave.addBreath(600, 0.12, 11);
  wave.tremble(14, 0.35, 0);
  wave.tremble(9, 0.3, 1);
  return finishLoop(std::span(&wave, 1), 0.6);
}

Pcm jump() {
  Wave wave(0.32, Wave::Shape::kOnce);
  wave.add(Tone{.frequency = 262, .endFrequency = 440, .attack = 0.012, .decay = 0.09, .seconds = 0.3});
  wave.add(Tone{.frequency = 524, .endFrequency = 880, .level = 0.12, .attack = 0.012, .decay = 0.05, .seconds = 0.3});
  wave.add(Puff{.cutoff = 900, .level = 0.15, .attack = 0.02, .decay = 0.05, .seconds = 0.2});
  return finishOnce(wave, 0.42);
}

Pcm land() {
  Wave wave(0.4, Wave::Shape::kOnce);
  wave.add(Tone{.frequency = 150, .endFrequency = 72, .attack = 0.004, .decay = 0.08, .seconds = 0.38});
  wave.add(Puff{.cutoff = 420, .level = 0.5, .attack = 0.004, .decay = 0.05, .seconds = 0.25});
  return finishOnce(wave, 0.7);
}

// A wooden rumble that slides from one note to another.
Pcm door(double from, double to) {
  Wave wave(0.9, Wave::Shape::kOnce);
  wave.add(Tone{.frequency = from, .endFrequency = to, .attack = 0.05, .decay = 0.35, .seconds = 0.85});
  wave.add(Tone{
      .frequency = from * 2, .endFrequency = to * 2, .level = 0.2, .attack = 0.08, .decay = 0.25, .seconds = 0.85});
  wave.add(Puff{.cutoff = 240, .level = 0.45, .attack = 0.06, .decay = 0.2, .seconds = 0.8});
  wave.echo(0.17, 0.3, 1);
  return finishOnce(wave, 0.6);
}

// A wooden knock on a note.
Pcm knock(int step, double decay, double peak) {
  Wave wave(decay * 6, Wave::Shape::kOnce);
  addBell(wave, 0, pentatonic(step), 1, decay);
  wave.add(Puff{.cutoff = 700, .level = 0.3, .attack = 0.003, .decay = 0.02, .seconds = 0.1});
  return finishOnce(wave, peak);
}

Pcm hazard() {
  Wave wave(0.9, Wave::Shape::kOnce);
  wave.add(Tone{.frequency = 330, .endFrequency = 110, .attack = 0.02, .decay = 0.22, .seconds = 0.85});
  wave.add(Tone{.frequency = 392, .endFrequency = 131, .level = 0.5, .attack = 0.03, .decay = 0.2, .seconds = 0.85});
  wave.add(Puff{.cutoff = 500, .level = 0.35, .attack = 0.05, .decay = 0.15, .seconds = 0.8});
  return finishOnce(wave, 0.6);
}

Pcm restart() {
  Wave wave(0.6, Wave::Shape::kOnce);
  wave.add(Tone{.frequency = 220, .endFrequency = 294, .attack = 0.15, .decay = 0.25, .seconds = 0.55});
  wave.add(Puff{.cutoff = 700, .level = 0.4, .attack = 0.15, .decay = 0.12, .seconds = 0.55});
  return finishOnce(wave, 0.4);
}

}  // namespace

double pentatonic(int step) {
  constexpr std::array<int, 5> kSemitones{0, 2, 4, 7, 9};
  const int octave = (step + 500) / 5 - 100;
  const int semitones = 12 * octave + kSemitones[static_cast<std::size_t>(step - 5 * octave)];
  return kD4 * std::pow(2, semitones / 12.0);
}

Pcm makeSound(Sound sound) {
  switch (sound) {
    case Sound::kRoll:
      return roll();
    case Sound::kJump:
      return jump();
    case Sound::kLand:
      return land();
    case Sound::kEdge:
      return chime({3}, 0, 0.28, 1.8, 0.55);
    case Sound::kGoal:
      return chime({0, 3, 5, 7, 8}, 0.13, 0.55, 3.6, 0.9);
    case Sound::kKey:
      return chime({4, 7}, 0.09, 0.25, 1.6, 0.55);
    case Sound::kDoorOpens:
      return door(pentatonic(-5), pentatonic(-2));
    case Sound::kDoorCloses:
      return door(pentatonic(-2), pentatonic(-5));
    case Sound::kPlateDown:
      return knock(-2, 0.09, 0.6);
    case Sound::kPlateUp:
      return knock(-1, 0.07, 0.45);
    case Sound::kFenceDown:
      return knock(4, 0.05, 0.25);
    case Sound::kFenceUp:
      return knock(2, 0.05, 0.25);
    case Sound::kHazard:
      return hazard();
    case Sound::kCheckpoint:
      return chime({3, 4, 5}, 0.1, 0.3, 2.0, 0.6);
    case Sound::kRestart:
      return restart();
    case Sound::kMenuMove:
      return knock(3, 0.03, 0.3);
    case Sound::kMenuChoose:
      return chime({3, 5}, 0.06, 0.12, 1.0, 0.4);
    case Sound::kCountdown:
      return knock(2, 0.12, 0.4);
    case Sound::kRoundStart:
      return chime({0, 5}, 0.02, 0.4, 2.4, 0.55);
  }
  return {};
}

}  // namespace platon
