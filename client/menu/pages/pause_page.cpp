#include "client/menu/pages/pause_page.h"

namespace platon {

MenuPage pausePage(const PauseChoices& choices) {
  MenuPage page{choices.title, choices.notes};
  page.items = {{.name = "Resume", .choose = choices.onResume},
                {.name = "Back to the start", .value = choices.restartKey, .choose = choices.onRestart},
                {.name = choices.next, .choose = choices.onNext},
                {.name = "Settings", .choose = choices.onSettings},
                {.name = "Return to the title", .choose = choices.onLeave}};
  if (choices.onWatch)
    page.items.insert(page.items.begin() + 3, {.name = "Watch your best run", .choose = choices.onWatch});
  if (choices.onSay)
    page.items.insert(page.items.begin() + 3, {.name = "Talk", .value = choices.sayKey, .choose = choices.onSay});
  page.back = choices.onResume;
  page.backMark = false;
  return page;
}

}  // namespace platon
