#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace platon {

/// What the picture of the game may cost.
struct Quality {
  int samples = 1;   ///< per pixel: 1, 2 or 4, limited by the driver
  double scale = 1;  ///< of the picture of the scene, kMinScale … 1; texts and overlays keep the size of the picture
  bool particles = true;  ///< trails, dust and motes in the sky
  bool fine = true;       ///< balls are rounder and shadows smoother

  static constexpr double kMinScale = 0.5;
  static constexpr int kMaxSamples = 4;

  friend bool operator==(const Quality&, const Quality&) = default;
};

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

}  // namespace platon
