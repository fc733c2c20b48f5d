#include "client/menu/pages/quality_items.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>

namespace platon {
namespace {

constexpr std::array<const char*, kQualities.size()> kQualityNames{"low", "medium", "high", "everything on"};
constexpr double kStep = 0.05;  // of the render scale

std::string nameOf(const QualityChoice& choice) {
  if (!choice.level) return "automatic";
  const std::string name = kQualityNames[static_cast<std::size_t>(*choice.level)];
  return choice.scale || choice.samples ? name + ", changed" : name;
}

void setScale(QualityChoice& choice, double scale) {
  const double exact = std::round(scale / kStep) * kStep;
  choice.scale = std::clamp(std::round(exact * 100) / 100, Quality::kMinScale, 1.0);
}

}  // namespace

MenuItem qualityItem(QualityChoice& choice) {
  MenuItem item{MenuItem::Kind::kChoice, "Quality", nameOf(choice)};
  item.step = [&choice](int direction) {
    const int now = static_cast<int>(choice.level.value_or(QualityLevel::kHigh));
    choice.choose(static_cast<QualityLevel>(std::clamp(now + direction, 0, static_cast<int>(kQualities.size()) - 1)));
  };
  return item;
}

MenuItem renderScaleItem(QualityChoice& choice) {
  const double scale = choice.quality().scale;
  MenuItem item{MenuItem::Kind::kSlider, "Render scale", std::to_string(std::lround(scale * 100)) + " %",
                (scale - Quality::kMinScale) / (1 - Quality::kMinScale)};
  item.step = [&choice](int direction) { setScale(choice, choice.quality().scale + direction * kStep); };
  item.set = [&choice](double part) { setScale(choice, Quality::kMinScale + part * (1 - Quality::kMinScale)); };
  return item;
}

MenuItem multisamplingItem(QualityChoice& choice) {
  const int samples = choice.quality().samples;
  MenuItem item{MenuItem::Kind::kChoice, "Multisampling", samples == 1 ? "off" : std::to_string(samples) + " samples"};
  item.step = [&choice](int direction) {
    const int now = choice.quality().samples;
    choice.samples = std::clamp(direction > 0 ? now * 2 : now / 2, 1, Quality::kMaxSamples);
  };
  return item;
}

MenuItem measureItem(QualityChoice& choice) {
  MenuItem item{MenuItem::Kind::kAction, "Measure and choose the quality"};
  item.choose = [&choice] { choice = {}; };
  return item;
}

}  // namespace platon
