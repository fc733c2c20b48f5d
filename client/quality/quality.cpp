#include "client/quality/quality.h"

#include <charconv>
#include <sstream>

namespace platon {
namespace {

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

}  // namespace

std::optional<QualityLevel> qualityLevelOf(std::string_view name) {
  for (const NamedQuality& named : kQualities)
    if (named.name == name) return named.level;
  return std::nullopt;
}

Quality QualityChoice::quality() const {
  Quality quality = namedQuality(level.value_or(QualityLevel::kHigh)).quality;
  quality.scale = scale.value_or(quality.scale);
  quality.samples = samples.value_or(quality.samples);
  return quality;
}

std::optional<std::string> textOf(QualityPart part, const QualityChoice& choice) {
  std::ostringstream out;
  switch (part) {
    case QualityPart::kLevel:
      out << (choice.level ? namedQuality(*choice.level).name : "auto");
      break;
    case QualityPart::kScale:
      if (choice.scale) out << *choice.scale;
      break;
    case QualityPart::kSamples:
      if (choice.samples) out << *choice.samples;
      break;
  }
  return out.str().empty() ? std::nullopt : std::optional(out.str());
}

bool parse(std::string_view value, QualityPart part, QualityChoice& choice) {
  switch (part) {
    case QualityPart::kLevel:
      return parseLevel(value, choice);
    case QualityPart::kScale:
      return parseScale(value, choice);
    case QualityPart::kSamples:
      return parseSamples(value, choice);
  }
  return false;
}

}  // namespace platon
