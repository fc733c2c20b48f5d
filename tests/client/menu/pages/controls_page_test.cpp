#include "client/menu/pages/controls_page.h"

#include <string>

#include <gtest/gtest.h>

namespace platon::controls_page_test {
namespace {

class ControlsPageTest : public testing::Test {
 protected:
  MenuPage page() { return controlsPage(bindings_, form_); }
  MenuItem row(Control control) { return page().items[static_cast<std::size_t>(control)]; }
  void press(Key key, KeyEvent::Kind kind = KeyEvent::Kind::kPress) { page().takeKey({key, kind}); }
  bool waits() { return page().takeKey != nullptr; }
  std::string note() { return page().notes.front(); }

  Bindings bindings_;
  ControlsForm form_;
};

TEST_F(ControlsPageTest, ShowsTheKeysOfEachControl) {
  EXPECT_EQ(row(Control::kLeft).value, "← or A, stick ←");
  EXPECT_EQ(row(Control::kSay).value, "T, pad X");
  bindings_.clear(Control::kSay);
  EXPECT_EQ(row(Control::kSay).value, "none");
  EXPECT_EQ(page().items.size(), kControlCount + 1);
}

TEST_F(ControlsPageTest, AChosenRowWaitsForTheNextKey) {
  EXPECT_FALSE(waits());
  row(Control::kJump).choose();
  ASSERT_TRUE(waits());
  EXPECT_EQ(row(Control::kJump).value, "…");
  press(Key::kEnter, KeyEvent::Kind::kRepeat);  // of the key that has chosen the row
  press(Key::kEnter, KeyEvent::Kind::kRelease);
  press(Key::kPadCreep);  // a stick that is not at rest
  ASSERT_TRUE(waits());
  press(Key::kJ);
  EXPECT_FALSE(waits());
  EXPECT_EQ(bindings_.controlOf(Key::kJ), Control::kJump);
  EXPECT_EQ(note(), "“Jump” has J now.");
}

TEST_F(ControlsPageTest, TellsFromWhomAKeyWasTaken) {
  row(Control::kJump).choose();
  press(Key::kV);
  EXPECT_EQ(note(), "“Jump” has taken V from “Next level, or vote”, which has pad Y now.");
  row(Control::kJump).choose();
  press(Key::kT);
  EXPECT_EQ(note(), "“Jump” has taken T from “Talk to all players”, which has pad X now.");
}

TEST_F(ControlsPageTest, EscapeAndStartLeaveEverythingAsItWas) {
  for (const Key key : {Key::kEscape, Key::kPadStart}) {
    row(Control::kJump).choose();
    press(key);
    EXPECT_FALSE(waits());
    EXPECT_EQ(bindings_, Bindings());
  }
}

TEST_F(ControlsPageTest, DeleteTakesAllKeys) {
  row(Control::kJump).choose();
  press(Key::kDelete);
  EXPECT_EQ(bindings_.keysOf(Control::kJump), ControlKeys());
}

TEST_F(ControlsPageTest, AFunctionKeyThatDoesNothingElseIsTaken) {
  row(Control::kVote).choose();
  press(Key::kF5);
  EXPECT_FALSE(waits());
  EXPECT_EQ(note(), "“Next level, or vote” has F5 now.");
  EXPECT_EQ(bindings_.keysOf(Control::kVote).first, Key::kF5);
}

TEST_F(ControlsPageTest, KeysOfTheProgramAreRefused) {
  row(Control::kJump).choose();
  press(Key::kF11);
  EXPECT_TRUE(waits());
  EXPECT_EQ(note().substr(0, 22), "F11 cannot be chosen. ");
  EXPECT_EQ(bindings_, Bindings());
}

TEST_F(ControlsPageTest, ResetGivesTheDefaults) {
  for (const Key key : {Key::kJ, Key::kV, Key::kPadX}) {
    row(Control::kJump).choose();
    press(key);
  }
  EXPECT_NE(bindings_, Bindings());
  page().items.back().choose();
  EXPECT_EQ(bindings_, Bindings());
}

}  // namespace
}  // namespace platon::controls_page_test
