#pragma once

#include <span>
#include <string>

#include "client/menu/menu_item.h"

namespace platon {

/// An item that turns a flag on and off.
MenuItem toggleItem(std::string name, bool& flag);

/// A value of a choice, and what it is called.
struct NamedValue {
  double value;
  const char* name;
};

/// An item that chooses one of `values`, which are in ascending order and outlive it. A number between two of them is
/// shown as the nearest.
MenuItem choiceItem(std::string name, double& number, std::span<const NamedValue> values);

/// The range of a slider.
struct SliderRange {
  double min;
  double max;
  double step;           ///< of a key; the range is a multiple of it
  double percent = 100;  ///< that 1 stands for
};

/// An item that moves a number through a range, shown in percent.
MenuItem percentItem(std::string name, double& number, const SliderRange& range);

}  // namespace platon
