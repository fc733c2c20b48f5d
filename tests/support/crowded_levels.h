#pragma once

#include <string>
#include <vector>

namespace platon {

/// A level that is built to make players as expensive as possible: as many segments as are allowed, where they cost
/// most.
struct CrowdedLevel {
  /// Builds the text. `crowding` 1 is the most that is allowed; with 5 % more, a level is invalid.
  using Text = std::string (*)(double crowding);

  std::string name;  ///< letters only
  Text text;
};

std::vector<CrowdedLevel> crowdedLevels();

}  // namespace platon
