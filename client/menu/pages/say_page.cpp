#include "client/menu/pages/say_page.h"

#include <utility>

#include "client/ui/chat_feed.h"

namespace platon {

MenuPage sayPage(TextField& text, const SayChoices& choices) {
  MenuPage page{"Talk to all players", choices.said};
  MenuItem field{MenuItem::Kind::kText, "Text"};
  field.field = &text;
  field.choose = choices.say;
  page.items.push_back(std::move(field));
  page.items.push_back({.name = "Send", .choose = choices.say});
  for (std::uint32_t i = 0; i < kEmoteNames.size(); ++i) {
    page.items.push_back({.name = kEmoteNames[i].first, .choose = [emote = choices.emote, i] { emote(i + 1); }});
  }
  page.back = choices.leave;
  return page;
}

}  // namespace platon
