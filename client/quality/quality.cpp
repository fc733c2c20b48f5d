#include "client/quality/quality.h"

namespace platon {

std::optional<QualityLevel> qualityLevelOf(std::string_view name) {
  for (const NamedQuality& named : kQualities)
    if (named.name == name) return named.level;
  return std::nullopt;
}

}  // namespace platon
