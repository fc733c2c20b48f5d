#include "client/audio/music.h"

#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "client/audio/sounds.h"
#include "client/audio/wave.h"

namespace platon {
namespace {

constexpr std::size_t kChords = 4;
constexpr double kChordSeconds = double{kMusicSeconds} / kChords;
constexpr double kOverlap = 1.6;  // length of a swell in lengths of a chord

// A single note that falls into the music like a drop.
struct Drop {
  double start;
  int step;
};

struct Mood {
  std::array<std::vector<int>, kChords> chords;  // steps of pentatonic()
  std::vector<double> overtones;                 // levels of the harmonics, from the second
  double detune;                                 // between left and right, part of the frequency
  double breathCutoff;                           // hertz
  double breathLevel;
  int trembles;  // periods over the music
  double trembleDepth;
  std::vector<Drop> drops;
  double dropLevel;
};

// Warm and restless: a flicker, and embers.
Mood fire() {
  return {{{{-9, -5, -2, 1}, {-6, -3, 0, 2}, {-8, -4, -1, 2}, {-9, -5, -3, 0}}},
          {0.5, 0.3, 0.16, 0.08},
          0.0016,
          500,
          0.02,
          67,
          0.16,
          {{2.5, 3}, {3.1, 5}, {9.7, 4}, {15.2, 2}, {15.9, 4}, {21.3, 3}},
          0.05};
}

// Deep and still: fifths, and hardly anything above them.
Mood earth() {
  return {{{{-10, -7, -5, -2}, {-10, -6, -5, -1}, {-7, -5, -2, 0}, {-10, -7, -5, -3}}},
          {0.35, 0.12},
          0.0007,
          180,
          0.03,
          4,
          0.1,
          {{5.5, 0}, {17.5, -2}},
          0.06};
}

// Light: high fifths in a wind.
Mood air() {
  return {{{{-5, -2, 3, 6}, {-4, 0, 2, 5}, {-5, -1, 3, 4}, {-2, 1, 3, 7}}},
          {0.12, 0.04},
          0.0024,
          1300,
          0.06,
          7,
          0.25,
          {{4, 8}, {10.6, 7}, {18.2, 8}},
          0.035};
}

// Waves, and drops that fall into them.
Mood water() {
  return {{{{-6, -3, 0, 2}, {-5, -2, 1, 3}, {-6, -1, 0, 4}, {-7, -3, 1, 2}}},
          {0.25, 0.1, 0.03},
          0.0032,
          450,
          0.035,
          10,
          0.3,
          {{0.7, 5},
           {1.9, 4},
           {3.6, 7},
           {6.4, 3},
           {8.9, 6},
           {10.3, 5},
           {13.1, 7},
           {14.6, 4},
           {17.8, 6},
           {19.2, 3},
           {22.4, 8}},
          0.075};
}

// Wide and far: open sounds from the lowest to the highest.
Mood ether() {
  return {{{{-10, -5, 0, 3, 8}, {-8, -3, 2, 5}, {-7, -2, 1, 6}, {-10, -5, -1, 4, 5}}},
          {0.3, 0.16, 0.1, 0.07, 0.04},
          0.0028,
          800,
          0.025,
          3,
          0.2,
          {{7.3, 10}, {16.1, 8}, {19.9, 7}},
          0.04};
}

Mood moodOf(SolidKind solid) {
  switch (solid) {
    case SolidKind::kTetrahedron:
      return fire();
    case SolidKind::kHexahedron:
      return earth();
    case SolidKind::kOctahedron:
      return air();
    case SolidKind::kDodecahedron:
      return ether();
    case SolidKind::kIcosahedron:
      return water();
  }
  return earth();
}

// Low notes are louder, for the ear hears them less.
double levelAt(double frequency) { return std::sqrt(200 / frequency); }

void addChord(Wave& wave, const Mood& mood, std::size_t chord, double tuning) {
  for (const int step : mood.chords[chord]) {
    const double frequency = pentatonic(step) * tuning;
    double harmonic = 1;
    const auto swell = [&](double level) {
      wave.addSwell(static_cast<double>(chord) * kChordSeconds, kOverlap * kChordSeconds, frequency * harmonic,
                    level * levelAt(frequency));
    };
    swell(1);
    for (const double level : mood.overtones) {
      harmonic += 1;
      swell(level);
    }
  }
}

void addDrops(Wave& wave, const Mood& mood, double delay) {
  for (const Drop& drop : mood.drops) {
    const double frequency = pentatonic(drop.step);
    for (int echo = 0; echo < 4; ++echo) {
      wave.add(Tone{.start = drop.start + delay + echo * 0.37,
                    .frequency = frequency,
                    .level = 20 * mood.dropLevel * std::pow(0.45, echo),
                    .attack = 0.02,
                    .decay = 0.5,
                    .seconds = 2});
    }
  }
}

Wave makeSide(const Mood& mood, bool right) {
  Wave wave(kMusicSeconds, Wave::Shape::kLoop);
  for (std::size_t chord = 0; chord < kChords; ++chord) addChord(wave, mood, chord, right ? 1 + mood.detune : 1);
  addDrops(wave, mood, right ? 0.11 : 0);
  wave.addBreath(mood.breathCutoff, 20 * mood.breathLevel, right ? 3 : 5);
  wave.tremble(mood.trembles, mood.trembleDepth, right ? std::numbers::pi / 2 : 0);
  return wave;
}

}  // namespace

Pcm makeMusic(SolidKind solid) {
  const Mood mood = moodOf(solid);
  const std::array<Wave, 2> sides{makeSide(mood, false), makeSide(mood, true)};
  return finishLoop(sides, 0.7);
}

}  // namespace platon
