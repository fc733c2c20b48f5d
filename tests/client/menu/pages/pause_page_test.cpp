#include "client/menu/pages/pause_page.h"

#include <gtest/gtest.h>

#include "client/ui/chat_feed.h"
#include "protocol/limits.h"

namespace platon::pause_page_test {
namespace {

TEST(PausePage, EachItemCallsItsOwn) {
  std::string called;
  const auto note = [&called](const char* name) { return [&called, name] { called += name; }; };
  PauseChoices choices;
  choices.title = "Pause";
  choices.notes = {"a note"};
  choices.next = "Vote";
  choices.nextKey = "V";
  choices.onResume = note("resume ");
  choices.onRestart = note("restart ");
  choices.onNext = note("next ");
  choices.onHelp = note("help ");
  choices.onSettings = note("settings ");
  choices.onLeave = note("leave ");
  const MenuPage page = pausePage(choices);
  for (const MenuItem& item : page.items) item.choose();
  page.back();
  EXPECT_EQ(called, "resume restart next help settings leave resume ");
  EXPECT_EQ(page.notes, choices.notes);
  EXPECT_EQ(page.items[2].name, "Vote");
  EXPECT_EQ(page.items[2].value, "V");
  EXPECT_EQ(page.title, "Pause");
}

TEST(PausePage, TheBestRunIsOfferedIfThereIsOne) {
  bool watched = false;
  PauseChoices choices;
  EXPECT_EQ(pausePage(choices).items.size(), 6U);
  choices.onWatch = [&watched] { watched = true; };
  const MenuPage page = pausePage(choices);
  ASSERT_EQ(page.items.size(), 7U);
  EXPECT_EQ(page.items[3].name, "Watch your best run");
  page.items[3].choose();
  EXPECT_TRUE(watched);
}

TEST(PausePage, WithOthersThePlayerCanSaySomethingWithoutAKeyboard) {
  bool says = false;
  PauseChoices choices;
  choices.onSay = [&says] { says = true; };
  choices.sayKey = "T";
  const MenuPage page = pausePage(choices);
  ASSERT_EQ(page.items.size(), 7U);
  EXPECT_EQ(page.items[3].name, "Talk");
  EXPECT_EQ(page.items[3].value, "T");
  page.items[3].choose();
  EXPECT_TRUE(says);
}

static_assert(kEmoteTexts.size() == kEmotes);

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

TEST(SayPage, TellsTheKeysThatSayTheEmotesWithoutThePage) {
  TextField text(kMaxChatBytes);
  SayChoices choices;
  choices.emoteKeys = {"1", "2", "3", "no key"};
  const MenuPage page = sayPage(text, choices);
  EXPECT_EQ(page.items[2].name + " " + page.items[2].value, "Wave 1");
  EXPECT_EQ(page.items[5].name + " " + page.items[5].value, "Thanks no key");
}

TEST(SayPage, ShowsWhatWasSaidWhileThePlayerAnswers) {
  TextField text(kMaxChatBytes);
  SayChoices choices;
  choices.said = {"Ben: here", "Ann: where are you?"};
  EXPECT_EQ(sayPage(text, choices).notes, choices.said);
}

}  // namespace
}  // namespace platon::pause_page_test
