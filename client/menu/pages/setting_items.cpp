#include "client/menu/pages/setting_items.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace platon {
namespace {

std::ptrdiff_t nearest(std::span<const NamedValue> values, double number) {
  const auto closer = [number](const NamedValue& a, const NamedValue& b) {
    return std::abs(a.value - number) < std::abs(b.value - number);
  };
  return std::min_element(values.begin(), values.end(), closer) - values.begin();
}

double onStep(double number, const SliderRange& range) {
  const double steps = std::round((number - range.min) / range.step);
  // Rounded, so that the settings file gets no digits of a rounding error.
  const double exact = std::round((range.min + steps * range.step) * 1e6) / 1e6;
  return std::clamp(exact, range.min, range.max);
}

}  // namespace

MenuItem toggleItem(std::string name, bool& flag) {
  MenuItem item{MenuItem::Kind::kToggle, std::move(name), flag ? "on" : "off", flag ? 1.0 : 0.0};
  item.step = [&flag](int) { flag = !flag; };
  return item;
}

MenuItem choiceItem(std::string name, double& number, std::span<const NamedValue> values) {
  const std::ptrdiff_t now = nearest(values, number);
  MenuItem item{MenuItem::Kind::kChoice, std::move(name), values[static_cast<std::size_t>(now)].name};
  item.step = [&number, values](int direction) {
    const std::ptrdiff_t last = std::ssize(values) - 1;
    const std::ptrdiff_t next = std::clamp<std::ptrdiff_t>(nearest(values, number) + direction, 0, last);
    number = values[static_cast<std::size_t>(next)].value;
  };
  return item;
}

MenuItem percentItem(std::string name, double& number, const SliderRange& range) {
  MenuItem item{MenuItem::Kind::kSlider, std::move(name), std::to_string(std::lround(number * range.percent)) + " %",
                (number - range.min) / (range.max - range.min)};
  item.step = [&number, range](int direction) { number = onStep(number + direction * range.step, range); };
  item.set = [&number, range](double part) { number = onStep(range.min + part * (range.max - range.min), range); };
  return item;
}

}  // namespace platon
