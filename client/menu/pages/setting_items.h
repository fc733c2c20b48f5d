#pragma once

#include <vector>

#include "client/menu/menu_page.h"
#include "client/ui/setting_table.h"

namespace platon {

/// The items of a page for a setting that is not hidden: one that changes it in `settings`, which outlive it, and below
/// that of the last part of the quality one that has it measured. A number between two choices is shown as the nearest.
/// A level of quality that is chosen takes the place of a render scale and of samples that were.
std::vector<MenuItem> itemsOf(const Setting& setting, Settings& settings);

}  // namespace platon
