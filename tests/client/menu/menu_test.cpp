#include "client/menu/menu.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/client/menu/sample_pages.h"

namespace platon::menu_test {
namespace {

using Kind = KeyEvent::Kind;

constexpr std::size_t kChoice = 3;
constexpr std::size_t kSlider = 4;
constexpr std::size_t kToggle = 5;
constexpr std::size_t kText = 6;

class MenuTest : public testing::Test {
 protected:
  MenuTest() { field_.setText("text"); }

  // A page with an item of each kind that notes what it is told.
  MenuPage valuePage() {
    MenuPage page{"Values"};
    page.items = itemsOfEveryKind(field_, false);
    for (MenuItem& item : page.items) {
      item.step = [this](int direction) { steps_.push_back(direction); };
      item.set = [this](double part) { part_ = part; };
    }
    page.items[1].choose = page.items[2].choose = [this] { chosen_.push_back(0); };
    page.standsAside = true;
    return page;
  }
  void openValues(std::size_t focus) {
    menu_.open([this] { return valuePage(); });
    menu_.setFocus(focus);
  }
  void openList(std::size_t count) {
    menu_.open([this, count] { return actionPage(count, chosen_); });
  }

  void tap(Key key, int times = 1) {
    for (int i = 0; i < times; ++i) {
      menu_.handle({key, Kind::kPress}, font_);
      menu_.handle({key, Kind::kRelease}, font_);
    }
  }
  void type(char32_t character) {
    KeyEvent event;
    event.kind = Kind::kCharacter;
    event.character = character;
    menu_.handle(event, font_);
  }
  void point(PointerEvent::Kind kind, glm::vec2 place, double scroll = 0) {
    PointerEvent event;
    event.kind = kind;
    event.place = place;
    event.scroll = scroll;
    menu_.handle(event, font_);
  }
  void click(glm::vec2 place) {
    point(PointerEvent::Kind::kPress, place);
    point(PointerEvent::Kind::kRelease, place);
  }
  MenuRow row(std::size_t item) const {
    for (const MenuRow& row : menu_.layout(font_).rows) {
      if (row.item == item) return row;
    }
    ADD_FAILURE() << "item " << item << " is not visible";
    return {};
  }
  static glm::vec2 middle(const MenuBox& box) { return (box.low + box.high) / 2.0F; }

  Font font_;
  Menu menu_;
  TextField field_{64};
  std::vector<std::size_t> chosen_;
  std::vector<int> steps_;
  double part_ = -1;
};

TEST_F(MenuTest, AClosedMenuShowsAndDoesNothing) {
  tap(Key::kEnter);
  click({640, 360});
  EXPECT_FALSE(menu_.isOpen());
  EXPECT_TRUE(menu_.overlay(font_, true).panels.empty());
}

TEST_F(MenuTest, TheFocusGoesRoundTheItemsAndPassesHeadings) {
  openList(4);
  EXPECT_EQ(menu_.focus(), 1U);
  tap(Key::kArrowUp);
  EXPECT_EQ(menu_.focus(), 3U);
  tap(Key::kArrowDown);
  EXPECT_EQ(menu_.focus(), 1U);
}

TEST_F(MenuTest, KeysAndGamepadMoveChooseAndGoBack) {
  const std::vector<std::vector<Key>> devices{{Key::kArrowDown, Key::kArrowUp, Key::kEnter, Key::kEscape},
                                              {Key::kS, Key::kW, Key::kSpace, Key::kEscape},
                                              {Key::kPadDown, Key::kPadUp, Key::kPadA, Key::kPadB}};
  for (const std::vector<Key>& keys : devices) {
    chosen_.clear();
    openList(4);
    tap(keys[0], 2);
    tap(keys[1]);
    tap(keys[2]);
    EXPECT_EQ(chosen_, (std::vector<std::size_t>{2}));
    menu_.push([this] { return valuePage(); });
    tap(keys[3]);
    EXPECT_EQ(menu_.focus(), 2U) << "the page before, as it was left";
    tap(keys[3]);
    EXPECT_TRUE(menu_.isOpen()) << "the first page has nothing before it";
  }
}

TEST_F(MenuTest, APageMaySayWhatGoingBackDoes) {
  menu_.open([this] {
    MenuPage page = actionPage(2, chosen_);
    page.back = [this] { menu_.close(); };
    return page;
  });
  tap(Key::kEscape);
  EXPECT_FALSE(menu_.isOpen());
}

TEST_F(MenuTest, KeyRepeatMovesButDoesNotChoose) {
  openList(4);
  menu_.handle({Key::kArrowDown, Kind::kRepeat}, font_);
  EXPECT_EQ(menu_.focus(), 2U);
  menu_.handle({Key::kEnter, Kind::kRepeat}, font_);
  menu_.handle({Key::kEnter, Kind::kPress, true}, font_);
  EXPECT_TRUE(chosen_.empty()) << "neither does Alt+Enter, which is full screen";
}

// Before, full screen went on and off as long as the key was held.
TEST_F(MenuTest, AKeyThatIsHeldTogglesOnce) {
  bool flips = false;
  const auto hold = [&](std::size_t item) {
    steps_.clear();
    menu_.open([&] {
      MenuPage page = valuePage();
      page.items[kChoice].flips = flips;
      return page;
    });
    menu_.setFocus(item);
    for (const Key key : {Key::kArrowRight, Key::kPadLeft}) {
      menu_.handle({key, Kind::kPress}, font_);
      for (int i = 0; i < 2; ++i) menu_.handle({key, Kind::kRepeat}, font_);
      menu_.handle({key, Kind::kRelease}, font_);
    }
    return steps_;
  };
  const std::vector once{1, -1};
  const std::vector often{1, 1, 1, -1, -1, -1};
  EXPECT_EQ(hold(kToggle), once);
  EXPECT_EQ(hold(kSlider), often);
  EXPECT_EQ(hold(kChoice), often);
  flips = true;
  EXPECT_EQ(hold(kChoice), once) << "a choice of two values";
}

TEST_F(MenuTest, LeftAndRightChangeValues) {
  for (const std::size_t item : {kChoice, kSlider, kToggle}) {
    steps_.clear();
    openValues(item);
    for (const Key key : {Key::kArrowLeft, Key::kPadLeft, Key::kArrowRight, Key::kPadRight, Key::kEnter}) tap(key);
    EXPECT_EQ(steps_, (std::vector{-1, -1, 1, 1, 1}));
  }
  steps_.clear();
  openValues(1);
  tap(Key::kArrowRight);
  EXPECT_TRUE(steps_.empty());
}

TEST_F(MenuTest, WhileAValueIsChangedTheMenuStandsAside) {
  openValues(kSlider);
  tap(Key::kArrowRight);
  EXPECT_TRUE(menu_.standsAside());
  tap(Key::kArrowDown);
  EXPECT_FALSE(menu_.standsAside());
  const MenuBox track = row(kSlider).control;
  point(PointerEvent::Kind::kPress, middle(track));
  EXPECT_TRUE(menu_.standsAside());
  point(PointerEvent::Kind::kRelease, middle(track));
  EXPECT_FALSE(menu_.standsAside());
}

TEST_F(MenuTest, AsksForAGameThatRunsWhileAValueIsChangedThatNeedsOne) {
  menu_.open([this] {
    MenuPage page = valuePage();
    page.items[kSlider].inMotion = true;
    return page;
  });
  menu_.setFocus(kSlider);
  EXPECT_FALSE(menu_.showsMotion());
  tap(Key::kArrowRight);
  EXPECT_TRUE(menu_.showsMotion());
  tap(Key::kArrowDown);
  tap(Key::kArrowRight);
  EXPECT_TRUE(menu_.standsAside());
  EXPECT_FALSE(menu_.showsMotion()) << "another item";
}

TEST_F(MenuTest, AFieldTakesWhatIsTypedAndEnterLeavesIt) {
  openValues(kText);
  for (const char32_t character : U"wasd") {
    if (character != 0) type(character);
  }
  tap(Key::kW);
  tap(Key::kSpace);
  EXPECT_EQ(menu_.focus(), kText) << "letters and the space bar move nothing";
  tap(Key::kBackspace);
  EXPECT_EQ(field_.text(), "textwas");
  tap(Key::kEnter);
  EXPECT_EQ(menu_.focus(), 1U);
  type(U'x');
  EXPECT_EQ(field_.text(), "textwas");
}

TEST_F(MenuTest, PastesFromTheClipboard) {
  menu_.setClipboard([] { return "pasted"; });
  openValues(kText);
  field_.setText("");
  menu_.handle({Key::kV, Kind::kPress, false, true}, font_);
  EXPECT_EQ(field_.text(), "pasted");
}

TEST_F(MenuTest, ThePointerGivesTheFocusAndAClickChooses) {
  openList(5);
  point(PointerEvent::Kind::kMove, middle(row(3).box));
  EXPECT_EQ(menu_.focus(), 3U);
  point(PointerEvent::Kind::kMove, middle(row(0).box));
  point(PointerEvent::Kind::kMove, {1, 1});
  EXPECT_EQ(menu_.focus(), 3U) << "a heading takes no focus";
  click(middle(row(2).box));
  click({1, 1});
  EXPECT_EQ(chosen_, (std::vector<std::size_t>{2}));
}

// Before, a mouse that somebody pushed against took the focus from the keys.
TEST_F(MenuTest, APointerAtRestLeavesTheFocusToTheKeys) {
  openList(6);
  const glm::vec2 place = middle(row(3).box);
  point(PointerEvent::Kind::kMove, place);
  tap(Key::kArrowDown);
  for (const glm::vec2 twitch : {glm::vec2(0, 0), glm::vec2(2, 1), glm::vec2(-2, -2), glm::vec2(0, 3)}) {
    point(PointerEvent::Kind::kMove, place + twitch);
    EXPECT_EQ(menu_.focus(), 4U);
  }
  point(PointerEvent::Kind::kMove, place + glm::vec2(5, 0));
  EXPECT_EQ(menu_.focus(), 3U) << "it has moved";
  tap(Key::kArrowUp);
  click(place + glm::vec2(5, 0));
  EXPECT_EQ(chosen_, (std::vector<std::size_t>{3})) << "a click needs no motion";
}

// Also a pointer that came to rest over a game.
TEST_F(MenuTest, APointerAtRestLeavesTheFocusToTheKeysFromTheBeginning) {
  openList(6);
  const glm::vec2 place = middle(row(3).box);
  menu_.close();
  point(PointerEvent::Kind::kMove, place);
  openList(6);
  tap(Key::kArrowDown);
  point(PointerEvent::Kind::kMove, place + glm::vec2(1, 0));
  EXPECT_EQ(menu_.focus(), 2U);
}

// It took the focus from the item with which the page began.
TEST_F(MenuTest, APointerAtRestLeavesTheFocusToAPageThatOpens) {
  openList(6);
  const glm::vec2 place = middle(row(3).box);
  menu_.close();
  point(PointerEvent::Kind::kMove, place);
  openList(6);
  point(PointerEvent::Kind::kMove, place + glm::vec2(1, 0));
  EXPECT_EQ(menu_.focus(), 1U);
  point(PointerEvent::Kind::kMove, place + glm::vec2(5, 0));
  EXPECT_EQ(menu_.focus(), 3U) << "it has moved";
}

TEST_F(MenuTest, TheMouseGoesBackByTwoButtonsAndByTheMark) {
  const auto pushed = [&] {
    openList(4);
    menu_.setFocus(2);
    menu_.push([this] { return valuePage(); });
  };
  for (const PointerEvent::Button button : {PointerEvent::Button::kRight, PointerEvent::Button::kBack}) {
    pushed();
    menu_.handle(PointerEvent{.kind = PointerEvent::Kind::kPress, .button = button}, font_);
    EXPECT_EQ(menu_.focus(), 2U) << "the page before, as it was left";
    menu_.handle(PointerEvent{.kind = PointerEvent::Kind::kPress, .button = button}, font_);
    EXPECT_TRUE(menu_.isOpen()) << "the first page has nothing before it";
  }
  EXPECT_TRUE(menu_.layout(font_).back.box.empty());
  pushed();
  click(middle(menu_.layout(font_).back.box));
  EXPECT_EQ(menu_.focus(), 2U);
  EXPECT_TRUE(chosen_.empty());
}

TEST_F(MenuTest, APageThatHasAnItemForItHasNoMarkThatGoesBack) {
  bool mark = true;
  menu_.open([&] {
    MenuPage page = actionPage(2, chosen_);
    page.back = [this] { menu_.close(); };
    page.backMark = mark;
    return page;
  });
  EXPECT_FALSE(menu_.layout(font_).back.box.empty());
  mark = false;
  EXPECT_TRUE(menu_.layout(font_).back.box.empty());
}

TEST_F(MenuTest, WhileTheMenuStandsAsideItHasNoMark) {
  openList(4);
  menu_.push([this] { return valuePage(); });
  menu_.setFocus(kSlider);
  tap(Key::kArrowRight);
  ASSERT_TRUE(menu_.standsAside());
  const glm::vec2 mark = middle(menu_.layout(font_).back.box);
  point(PointerEvent::Kind::kPress, mark);
  EXPECT_TRUE(menu_.standsAside());
}

TEST_F(MenuTest, ClicksChangeValues) {
  openValues(1);
  const MenuRow choice = row(kChoice);
  click({choice.control.low.x + 4, middle(choice.box).y});
  click({choice.control.high.x - 4, middle(choice.box).y});
  click(middle(row(kToggle).box));
  EXPECT_EQ(steps_, (std::vector{-1, 1, 1}));
}

// The slider of the game's speed goes when another player joins.
TEST_F(MenuTest, ASliderThatGoesWhileItIsDraggedEndsTheDrag) {
  bool slides = true;
  menu_.open([&] {
    MenuPage page = valuePage();
    if (!slides) page.items[kSlider] = {.name = "name"};
    return page;
  });
  menu_.setFocus(kSlider);
  const MenuBox track = row(kSlider).control;
  const float y = (track.low.y + track.high.y) / 2;
  point(PointerEvent::Kind::kPress, {track.low.x + track.width() / 4, y});
  ASSERT_NEAR(part_, 0.25, 1e-5);
  part_ = -1;
  slides = false;
  point(PointerEvent::Kind::kMove, {track.low.x + track.width() / 2, y});
  slides = true;
  point(PointerEvent::Kind::kMove, {track.low.x + track.width() / 2, y});
  EXPECT_EQ(part_, -1);
}

TEST_F(MenuTest, ASliderFollowsThePointerUntilTheButtonIsReleased) {
  openValues(1);
  const MenuBox track = row(kSlider).control;
  const float y = middle(track).y;
  point(PointerEvent::Kind::kPress, {track.low.x + track.width() / 4, y});
  EXPECT_NEAR(part_, 0.25, 1e-5);
  point(PointerEvent::Kind::kMove, {track.high.x + 300, y + 200});
  EXPECT_EQ(part_, 1);
  point(PointerEvent::Kind::kMove, {0, y});
  EXPECT_EQ(part_, 0);
  point(PointerEvent::Kind::kRelease, {0, y});
  point(PointerEvent::Kind::kMove, middle(track));
  EXPECT_EQ(part_, 0);
  click({row(kSlider).name.box.low.x, y});
  EXPECT_EQ(part_, 0) << "a click on the name changes nothing";
}

TEST_F(MenuTest, TheWheelScrollsAndTheFocusStaysVisible) {
  openList(60);
  const std::size_t rows = menu_.layout(font_).rows.size();
  const glm::vec2 outside(1, 1);
  point(PointerEvent::Kind::kScroll, outside, -3);
  EXPECT_EQ(menu_.layout(font_).first, 6U);
  EXPECT_EQ(menu_.focus(), 6U);
  point(PointerEvent::Kind::kScroll, outside, -99);
  EXPECT_EQ(menu_.layout(font_).first, 60 - rows);
  point(PointerEvent::Kind::kScroll, outside, 99);
  EXPECT_EQ(menu_.layout(font_).first, 0U);
  EXPECT_LT(menu_.focus(), rows);
  point(PointerEvent::Kind::kScroll, middle(row(4).box), -1);
  EXPECT_EQ(menu_.focus(), 6U) << "what is under the pointer";
}

TEST_F(MenuTest, GoingDownAndUpMovesTheRowsOnlyAtTheirEnds) {
  openList(60);
  const std::size_t rows = menu_.layout(font_).rows.size();
  tap(Key::kArrowDown, static_cast<int>(rows));
  EXPECT_EQ(menu_.layout(font_).first, 2U);
  tap(Key::kArrowUp, 3);
  EXPECT_EQ(menu_.layout(font_).first, 2U);
}

TEST_F(MenuTest, PlacesFollowTheScale) {
  menu_.resize(1280, 1.5F);
  openList(5);
  const glm::vec2 place = middle(row(3).box) * 1.5F;
  click(place);
  EXPECT_EQ(chosen_, (std::vector<std::size_t>{3}));
}

TEST_F(MenuTest, AFocusBeyondTheEndOfAShorterPageGoesToItsFirstItem) {
  std::size_t count = 5;
  menu_.open([this, &count] { return actionPage(count, chosen_); });
  menu_.setFocus(4);
  count = 2;
  EXPECT_FALSE(menu_.overlay(font_, false).texts.empty());
  tap(Key::kEnter);
  EXPECT_EQ(chosen_, (std::vector<std::size_t>{1}));
}

TEST_F(MenuTest, GivesTheSameFeedbackWhateverTheDevice) {
  const std::vector<std::vector<Key>> devices{{Key::kArrowDown, Key::kArrowRight, Key::kEnter},
                                              {Key::kS, Key::kD, Key::kSpace},
                                              {Key::kPadDown, Key::kPadRight, Key::kPadA}};
  for (const std::vector<Key>& keys : devices) {
    openValues(kChoice);
    EXPECT_EQ(menu_.takeFeedback(), Menu::Feedback::kChosen) << "another page";
    EXPECT_EQ(menu_.takeFeedback(), Menu::Feedback::kNone);
    tap(keys[0]);
    EXPECT_EQ(menu_.takeFeedback(), Menu::Feedback::kMoved);
    tap(keys[1]);
    EXPECT_EQ(menu_.takeFeedback(), Menu::Feedback::kMoved);
    menu_.setFocus(1);
    tap(keys[2]);
    EXPECT_EQ(menu_.takeFeedback(), Menu::Feedback::kChosen);
    tap(Key::kShift);
    EXPECT_EQ(menu_.takeFeedback(), Menu::Feedback::kNone);
  }
}

TEST_F(MenuTest, GivesFeedbackToTheMouse) {
  openList(4);
  menu_.takeFeedback();
  point(PointerEvent::Kind::kMove, middle(row(2).box));
  EXPECT_EQ(menu_.takeFeedback(), Menu::Feedback::kMoved);
  point(PointerEvent::Kind::kMove, middle(row(2).box));
  EXPECT_EQ(menu_.takeFeedback(), Menu::Feedback::kNone);
  click(middle(row(2).box));
  EXPECT_EQ(menu_.takeFeedback(), Menu::Feedback::kChosen);
  menu_.close();
  EXPECT_EQ(menu_.takeFeedback(), Menu::Feedback::kChosen);
  menu_.close();
  EXPECT_EQ(menu_.takeFeedback(), Menu::Feedback::kNone);
}

}  // namespace
}  // namespace platon::menu_test
