#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "client/quality/quality.h"

namespace platon {

/// What the frames of one quality cost.
struct FrameCost {
  QualityLevel quality = QualityLevel::kLow;
  double p50Ms = 0;             ///< median time of a frame, until OpenGL has finished it
  double p99Ms = 0;             ///< time within which 99 % of the frames are finished
  double allCpuMs = 0;          ///< median processor time of a frame in all threads, those of the driver too
  double ownCpuMs = 0;          ///< median processor time of a frame and a tick, without the draw calls
  std::uint32_t drawCalls = 0;  ///< median of a frame
};

/// The result of `platon-client --benchmark`.
struct BenchmarkReport {
  std::string driver;                              ///< that draws, as it calls itself
  std::uint32_t frames = 0;                        ///< of each quality
  std::array<FrameCost, kQualities.size()> costs;  ///< in the order of kQualities

  /// The quality that a first start with these times chooses.
  QualityLevel chosen() const;
};

/// As the line of JSON in docs/playing.md.
std::string toJson(const BenchmarkReport& report);
/// As a table.
std::string toText(const BenchmarkReport& report);

}  // namespace platon
