#include "client/menu/pages/failure_page.h"

#include <sstream>

namespace platon {

MenuPage failurePage(const std::string& title, const std::string& reason, const std::function<void()>& retry,
                     const std::function<void()>& back) {
  MenuPage page{title};
  std::istringstream lines(reason);
  for (std::string line; std::getline(lines, line);) page.notes.push_back(line);
  page.warning = true;
  page.items = {{.name = "Try again", .choose = retry}, {.name = "Back", .choose = back}};
  page.back = back;
  return page;
}

}  // namespace platon
