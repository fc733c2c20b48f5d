#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

namespace platon {

/// What the picture of the game may cost.
struct Quality {
  int samples;     ///< per pixel: 1, 2 or 4, limited by the driver
  double scale;    ///< of the picture of the scene, kMinScale … 1; texts and overlays keep the size of the picture
  bool particles;  ///< trails, dust and motes in the sky
  bool fine;       ///< balls are rounder and shadows smoother

  static constexpr double kMinScale = 0.5;
  static constexpr int kMaxSamples = 4;

  friend bool operator==(const Quality&, const Quality&) = default;
};
static_assert(std::is_trivially_default_constructible_v<Quality>,
              "a member has no default, so that a row of kQualities without it does not compile");

/// The qualities that have a name, from the cheapest to everything on.
enum class QualityLevel : std::uint8_t { kLow, kMedium, kHigh, kAll };

struct NamedQuality {
  QualityLevel level;
  std::string_view name;
  Quality quality;
};

/// In the order of QualityLevel; each draws at least what the one before draws.
inline constexpr std::array<NamedQuality, 4> kQualities{{{QualityLevel::kLow, "low", {1, 1, false, false}},
                                                         {QualityLevel::kMedium, "medium", {1, 1, false, true}},
                                                         {QualityLevel::kHigh, "high", {1, 1, true, true}},
                                                         {QualityLevel::kAll, "all", {4, 1, true, true}}}};

/// Everything on.
inline constexpr Quality kBestQuality = kQualities.back().quality;

constexpr const NamedQuality& namedQuality(QualityLevel level) { return kQualities[static_cast<std::size_t>(level)]; }

/// The level of this name; nothing if there is none.
std::optional<QualityLevel> qualityLevelOf(std::string_view name);

/// The quality that the player wants.
struct QualityChoice {
  std::optional<QualityLevel> level;  ///< unset: to be chosen by measuring
  std::optional<double> scale;        ///< instead of that of the level: Quality::kMinScale … 1
  std::optional<int> samples;         ///< instead of that of the level: 1, 2 or 4

  /// The quality of pictures; without a level, `high`.
  Quality quality() const;
  /// Chooses a level, as it is.
  void choose(QualityLevel chosen) { *this = {chosen, std::nullopt, std::nullopt}; }

  friend bool operator==(const QualityChoice&, const QualityChoice&) = default;
};

/// A part of the choice; each is a line of the settings file.
enum class QualityPart : std::uint8_t { kLevel, kScale, kSamples };

inline constexpr std::array<QualityPart, 3> kQualityParts{QualityPart::kLevel, QualityPart::kScale,
                                                          QualityPart::kSamples};

/// What its value must be, as it follows "must be".
constexpr std::string_view allowedValues(QualityPart part) {
  switch (part) {
    case QualityPart::kLevel:
      return "auto, low, medium, high or all";
    case QualityPart::kScale:
      return "a number from 0.5 to 1";
    case QualityPart::kSamples:
      return "1, 2 or 4";
  }
  return {};
}
// Only a value that is no part has a null text.
static_assert(allowedValues(static_cast<QualityPart>(kQualityParts.size())).data() == nullptr,
              "kQualityParts lacks a part");

/// Its value in the file; nothing if a scale or samples are not set.
std::optional<std::string> textOf(QualityPart part, const QualityChoice& choice);
/// Stores a valid value of the file and returns true; otherwise it changes nothing and returns false.
bool parse(std::string_view value, QualityPart part, QualityChoice& choice);

}  // namespace platon
