#include "client/ui/controls/mouse_look.h"

#include <gtest/gtest.h>

namespace platon::mouse_look_test {
namespace {

using Button = PointerEvent::Button;
using Kind = PointerEvent::Kind;

class MouseLookTest : public testing::Test {
 protected:
  void event(Kind kind, glm::dvec2 place, Button button = Button::kLeft) {
    PointerEvent pointer;
    pointer.kind = kind;
    pointer.place = place;
    pointer.button = button;
    look_.handle(pointer);
  }

  MouseLook look_;
};

TEST_F(MouseLookTest, TheSolidFollowsThePointerWhileTheRightButtonIsHeld) {
  event(Kind::kMove, {500, 300});
  EXPECT_EQ(look_.take({}), LookInput());
  event(Kind::kPress, {500, 300}, Button::kRight);
  event(Kind::kMove, {520, 300});
  event(Kind::kMove, {520, 290});
  const LookInput look = look_.take({});
  EXPECT_TRUE(look.held);
  EXPECT_DOUBLE_EQ(look.turn.x, -20 * MouseLook::kTurn) << "to the left of a solid that goes to the right";
  EXPECT_DOUBLE_EQ(look.turn.y, -10 * MouseLook::kTurn);
  EXPECT_EQ(look_.take({}).turn, glm::dvec2(0)) << "it was taken";
  event(Kind::kRelease, {520, 290}, Button::kRight);
  event(Kind::kMove, {600, 290});
  EXPECT_EQ(look_.take({}), LookInput());
}

TEST_F(MouseLookTest, OtherButtonsAndTheWheelDoNothing) {
  event(Kind::kPress, {0, 0}, Button::kLeft);
  event(Kind::kMove, {50, 0});
  event(Kind::kPress, {50, 0}, Button::kMiddle);
  event(Kind::kScroll, {50, 0});
  EXPECT_EQ(look_.take({}), LookInput());
}

TEST_F(MouseLookTest, ReleasedItWaitsForTheNextPress) {
  event(Kind::kPress, {0, 0}, Button::kRight);
  event(Kind::kMove, {50, 0});
  look_.release();
  event(Kind::kMove, {90, 0});
  EXPECT_EQ(look_.take({}), LookInput());
  event(Kind::kPress, {90, 0}, Button::kRight);
  EXPECT_TRUE(look_.take({}).held);
}

TEST_F(MouseLookTest, KeepsWhatKeysAndGamepadDo) {
  const LookInput keys{true, {1, 0}, {}};
  EXPECT_EQ(look_.take(keys), keys);
}

}  // namespace
}  // namespace platon::mouse_look_test
