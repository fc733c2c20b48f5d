#include "client/menu/pages/failure_page.h"

#include <sstream>

namespace platon {

MenuPage failurePage(const std::string& title, const std::string& reason, const std::function<void()>& retry,
                     const std::function<void()>& back, const std::optional<MenuItem>& other) {
  MenuPage page{title};
  std::istringstream lines(reason);
  for (std::string line; std::getline(lines, line);) page.notes.push_back(line);
  page.warning = true;
  page.items = {{.name = "Try again", .choose = retry}, {.name = "Back", .choose = back}};
  if (other) page.items.insert(page.items.begin(), *other);
  page.back = back;
  page.backMark = false;
  return page;
}

}  // namespace platon
