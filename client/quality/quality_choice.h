#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "client/quality/quality.h"

namespace platon {

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

/// What its value must be, as it follows "must be".
std::string_view allowedValues(QualityPart part);
/// Its value in the file; nothing if a scale or samples are not set.
std::optional<std::string> textOf(QualityPart part, const QualityChoice& choice);
/// Stores a valid value of the file and returns true; otherwise it changes nothing and returns false.
bool parse(std::string_view value, QualityPart part, QualityChoice& choice);

}  // namespace platon
