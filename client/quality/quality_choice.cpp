#include "client/quality/quality_choice.h"

#include <charconv>
#include <sstream>

namespace platon {

Quality QualityChoice::quality() const {
  Quality quality = namedQuality(level.value_or(QualityLevel::kHigh)).quality;
  quality.scale = scale.value_or(quality.scale);
  quality.samples = samples.value_or(quality.samples);
  return quality;
}

std::string QualityChoice::text() const {
  std::ostringstream out;
  out << "quality " << (level ? namedQuality(*level).name : "auto") << "\n";
  if (scale) out << "render-scale " << *scale << "\n";
  if (samples) out << "multisampling " << *samples << "\n";
  return out.str();
}

bool parseLevel(std::string_view value, QualityChoice& choice) {
  const std::optional<QualityLevel> level = qualityLevelOf(value);
  if (!level && value != "auto") return false;
  choice.level = level;
  return true;
}

bool parseScale(std::string_view value, QualityChoice& choice) {
  double scale = 0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), scale);
  if (error != std::errc() || end != value.data() + value.size()) return false;
  if (!(scale >= Quality::kMinScale && scale <= 1)) return false;
  choice.scale = scale;
  return true;
}

bool parseSamples(std::string_view value, QualityChoice& choice) {
  if (value != "1" && value != "2" && value != "4") return false;
  choice.samples = value.front() - '0';
  return true;
}

}  // namespace platon
