#include "client/ui/controls/local_devices.h"

#include <gtest/gtest.h>

namespace platon::local_devices_test {
namespace {

KeyEvent keyboard(Key key) { return {.key = key}; }
KeyEvent gamepad(int pad) { return {.key = Key::kPadRightTrigger, .pad = pad}; }

TEST(LocalDevices, TheFirstPlayerHasWhatNobodyElseHas) {
  const Bindings second(KeySet::kSecond);
  LocalDevices devices;
  EXPECT_EQ(devices.ownerOf(keyboard(Key::kArrowLeft), second), 0U);
  EXPECT_EQ(devices.ownerOf(gamepad(3), second), 0U);
  EXPECT_EQ(devices.toggle(keyboard(Key::kF2)), DeviceChange::kJoined);
  EXPECT_EQ(devices.toggle(gamepad(3)), DeviceChange::kJoined);
  EXPECT_EQ(devices.ownerOf(keyboard(Key::kArrowLeft), second), 1U);
  EXPECT_EQ(devices.ownerOf(keyboard(Key::kA), second), 0U);
  EXPECT_EQ(devices.ownerOf(gamepad(3), second), 2U);
  EXPECT_EQ(devices.ownerOf(gamepad(0), second), 0U);
  EXPECT_TRUE(devices.sharesKeyboard());
}

TEST(LocalDevices, TheLowestFreeNumberIsGiven) {
  LocalDevices devices;
  for (const int pad : {5, 6, 7}) EXPECT_EQ(devices.toggle(gamepad(pad)), DeviceChange::kJoined);
  EXPECT_EQ(devices.toggle(gamepad(8)), DeviceChange::kNone);
  EXPECT_EQ(devices.toggle(keyboard(Key::kF2)), DeviceChange::kNone);
  EXPECT_EQ(devices.toggle(gamepad(6)), DeviceChange::kLeft);
  EXPECT_FALSE(devices.has(2));
  EXPECT_EQ(devices.toggle(keyboard(Key::kF2)), DeviceChange::kJoined);
  EXPECT_TRUE(devices.has(2));
  devices.remove(1);
  EXPECT_FALSE(devices.has(1));
}

TEST(LocalDevices, FourGamepadsThatAreUnpluggedInTurnComeBackInTurn) {
  const Bindings second(KeySet::kSecond);
  LocalDevices devices;
  for (const int pad : {1, 2, 3}) devices.toggle(gamepad(pad));
  EXPECT_FALSE(devices.lose(0)) << "that of the first player";
  for (const int pad : {1, 2, 3}) EXPECT_TRUE(devices.lose(pad));
  for (std::uint32_t local = 1; local < kMaxLocalPlayers; ++local) EXPECT_TRUE(devices.has(local)) << "nothing is lost";
  for (const int pad : {9, 8, 7}) EXPECT_EQ(devices.toggle(gamepad(pad)), DeviceChange::kReturned);
  EXPECT_EQ(devices.ownerOf(gamepad(9), second), 1U);
  EXPECT_EQ(devices.ownerOf(gamepad(7), second), 3U);
}

TEST(LocalDevices, TheSameGamepadPlaysOnWhenItIsBack) {
  const Bindings second(KeySet::kSecond);
  LocalDevices devices;
  devices.toggle(gamepad(1));
  devices.toggle(gamepad(2));
  devices.lose(1);
  devices.observe({.key = Key::kPadLeft, .pad = 1});
  EXPECT_EQ(devices.ownerOf(gamepad(1), second), 1U);
  EXPECT_EQ(devices.toggle(gamepad(5)), DeviceChange::kJoined) << "nobody waits for a gamepad";
  EXPECT_EQ(devices.toggle(gamepad(1)), DeviceChange::kLeft);
}

}  // namespace
}  // namespace platon::local_devices_test
