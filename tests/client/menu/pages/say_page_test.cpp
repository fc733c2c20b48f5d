#include "client/menu/pages/say_page.h"

#include <gtest/gtest.h>

#include "client/ui/chat_feed.h"
#include "protocol/limits.h"

namespace platon::say_page_test {
namespace {

static_assert(kEmoteNames.size() == kEmotes);

TEST(SayPage, EachItemCallsItsOwn) {
  std::string called;
  TextField text(kMaxChatBytes);
  const MenuPage page =
      sayPage(text, {[&] { called += "say "; }, [&](std::uint32_t emote) { called += std::to_string(emote) + " "; },
                     [&] { called += "leave"; }});
  EXPECT_EQ(page.items.front().field, &text);
  for (const MenuItem& item : page.items) {
    if (item.choose) item.choose();
  }
  page.back();
  EXPECT_EQ(called, "say say 1 2 3 4 leave");
}

TEST(SayPage, ShowsWhatWasSaidWhileThePlayerAnswers) {
  TextField text(kMaxChatBytes);
  SayChoices choices;
  choices.said = {"Ben: here", "Ann: where are you?"};
  EXPECT_EQ(sayPage(text, choices).notes, choices.said);
}

}  // namespace
}  // namespace platon::say_page_test
