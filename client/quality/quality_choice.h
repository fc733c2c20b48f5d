#pragma once

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

  /// The lines of the settings file.
  std::string text() const;

  friend bool operator==(const QualityChoice&, const QualityChoice&) = default;
};

/// Each stores a valid value of a line of QualityChoice::text() and returns true; otherwise it changes nothing and
/// returns false.
bool parseLevel(std::string_view value, QualityChoice& choice);
bool parseScale(std::string_view value, QualityChoice& choice);
bool parseSamples(std::string_view value, QualityChoice& choice);

}  // namespace platon
