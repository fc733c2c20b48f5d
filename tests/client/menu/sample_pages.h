#pragma once

#include <string>
#include <vector>

#include "client/menu/menu_page.h"

namespace platon {

/// An item of each kind; `isLong`: with the longest texts that can be.
inline std::vector<MenuItem> itemsOfEveryKind(TextField& field, bool isLong) {
  const std::string text = isLong ? std::string(90, 'W') : "name";
  std::vector<MenuItem> items{{MenuItem::Kind::kHeading, text},
                              {MenuItem::Kind::kAction, text},
                              {MenuItem::Kind::kAction, text, text},
                              {MenuItem::Kind::kChoice, text, text},
                              {MenuItem::Kind::kSlider, text, isLong ? text : "100 %", 0.5},
                              {MenuItem::Kind::kToggle, text, "off"},
                              {MenuItem::Kind::kText, text}};
  items.back().field = &field;
  return items;
}

/// A page with `count` items, the first of which is a heading, that note their numbers when they are chosen.
inline MenuPage actionPage(std::size_t count, std::vector<std::size_t>& chosen) {
  MenuPage page{"Page"};
  page.items.push_back({MenuItem::Kind::kHeading, "Group"});
  for (std::size_t i = 1; i < count; ++i)
    page.items.push_back({.name = "item " + std::to_string(i), .choose = [i, &chosen] { chosen.push_back(i); }});
  return page;
}

}  // namespace platon
