#include "client/menu/pages/pause_page.h"

#include <utility>

namespace platon {

MenuPage pausePage(const PauseChoices& choices) {
  MenuPage page{choices.title, choices.notes};
  page.items = {{.name = "Resume", .choose = choices.onResume},
                {.name = "Back to the start", .value = choices.restartKey, .choose = choices.onRestart},
                {.name = choices.next, .value = choices.nextKey, .choose = choices.onNext},
                {.name = "Show all keys", .value = "F1", .choose = choices.onHelp},
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

MenuPage sayPage(TextField& text, const SayChoices& choices) {
  MenuPage page{"Talk to all players", choices.said};
  MenuItem field{MenuItem::Kind::kText, "Text"};
  field.field = &text;
  field.choose = choices.say;
  page.items.push_back(std::move(field));
  page.items.push_back({.name = "Send", .choose = choices.say});
  for (std::uint32_t i = 0; i < kEmoteTexts.size(); ++i) {
    page.items.push_back({.name = kEmoteTexts[i].chosen,
                          .value = choices.emoteKeys[i],
                          .choose = [emote = choices.emote, i] { emote(i + 1); }});
  }
  page.back = choices.leave;
  return page;
}

}  // namespace platon
