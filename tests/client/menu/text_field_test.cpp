#include "client/menu/text_field.h"

#include <gtest/gtest.h>

namespace platon::text_field_test {
namespace {

using Kind = KeyEvent::Kind;

bool key(TextField& field, Key key, bool ctrl = false) {
  return field.handle({key, Kind::kPress, false, ctrl}, [] { return "pasted\n"; });
}

void type(TextField& field, std::u32string_view text) {
  for (const char32_t character : text) {
    KeyEvent event;
    event.kind = Kind::kCharacter;
    event.character = character;
    EXPECT_TRUE(field.handle(event, nullptr));
  }
}

TEST(TextField, TakesCharactersOfEveryLength) {
  TextField field(64);
  type(field, U"aß€😀");
  EXPECT_EQ(field.text(), "aß€😀");
  EXPECT_EQ(field.caret(), field.text().size());
}

TEST(TextField, TheCaretMovesAndErasesByCharacters) {
  TextField field(64);
  field.setText("aß€");
  key(field, Key::kArrowLeft);
  EXPECT_EQ(field.caret(), 3U);
  key(field, Key::kBackspace);
  EXPECT_EQ(field.text(), "a€");
  key(field, Key::kDelete);
  EXPECT_EQ(field.text(), "a");
  key(field, Key::kHome);
  key(field, Key::kBackspace);
  key(field, Key::kArrowLeft);
  type(field, U"b");
  EXPECT_EQ(field.text(), "ba");
  key(field, Key::kEnd);
  key(field, Key::kArrowRight);
  key(field, Key::kDelete);
  type(field, U"c");
  EXPECT_EQ(field.text(), "bac");
  key(field, Key::kHome);
  key(field, Key::kArrowRight);
  EXPECT_EQ(field.caret(), 1U);
}

TEST(TextField, PastesWithoutControlCharacters) {
  TextField field(64);
  field.setText("ab");
  key(field, Key::kArrowLeft);
  key(field, Key::kV, true);
  EXPECT_EQ(field.text(), "apastedb");
  EXPECT_EQ(field.caret(), 7U);
  field.insert("\xff\x01x");
  EXPECT_EQ(field.text(), "apastedxb");
}

TEST(TextField, TakesNoMoreThanItsBytes) {
  TextField field(4);
  field.insert("abc€");
  EXPECT_EQ(field.text(), "abc");
  type(field, U"de");
  EXPECT_EQ(field.text(), "abcd");
}

TEST(TextField, LeavesTheKeysThatMoveThroughAMenu) {
  TextField field(8);
  for (const Key each : {Key::kArrowUp, Key::kArrowDown, Key::kEnter, Key::kEscape, Key::kPadA, Key::kPadUp, Key::kF11})
    EXPECT_FALSE(key(field, each));
  for (const Key each : {Key::kW, Key::kS, Key::kSpace, Key::kArrowLeft, Key::kV}) EXPECT_TRUE(key(field, each));
  EXPECT_EQ(field.text(), "");
}

}  // namespace
}  // namespace platon::text_field_test
