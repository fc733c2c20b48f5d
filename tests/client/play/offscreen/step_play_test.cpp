#include "client/play/offscreen/step_play.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "client/ui/controls/key_names.h"
#include "levels/solve/recorded_way.h"
#include "platon/game/input.h"
#include "protocol/hash_text.h"
#include "tests/support/environment_variable.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon::step_play_test {
namespace {

// The files of a player who has never played.
struct NewPlayer {
  std::string file(const std::string& name) const { return (folder / name).string(); }

  TemporaryFolder folder;
  EnvironmentVariable config{"XDG_CONFIG_HOME", folder.path()};
  EnvironmentVariable data{"XDG_DATA_HOME", folder.path()};
  EnvironmentVariable cache{"XDG_CACHE_HOME", folder / "cache"};
  EnvironmentVariable state{"XDG_STATE_HOME", folder.path()};
  EnvironmentVariable pictures{"XDG_PICTURES_DIR", folder.path()};
};

ClientOptions optionsOf(const std::string& level = "") {
  ClientOptions options;
  options.offscreen = true;
  options.step = true;
  options.level = level;
  options.frames.width = 480;
  return options;
}

// The pictures after each of the commands, which a new player gives.
std::vector<std::string> picturesOf(const std::vector<std::string>& commands, const std::string& level = "") {
  const NewPlayer player;
  StepPlay play(optionsOf(level));
  std::vector<std::string> pictures;
  for (const std::string& command : commands) {
    EXPECT_EQ(play.obey(command).substr(0, 3), "ok ") << command;
    EXPECT_EQ(play.obey("shot " + player.file("picture.png")).substr(0, 3), "ok ");
    pictures.push_back(readText(player.file("picture.png")));
  }
  return pictures;
}

TEST(StepPlay, EveryKeyIsNamedByTheSettingsAndByWhatThePlayerReads) {
  for (std::size_t i = 0; i < kKeyCount; ++i) {
    const Key key = static_cast<Key>(i);
    const std::string shown(shownNameOf(key));
    if (canBeBound(key)) EXPECT_EQ(keyOfName(wordOf(key)), key) << shown;
    EXPECT_EQ(shownNameOf(keyOfName(shown).value_or(Key::kF12)), shown) << "the sticks share their names";
  }
  EXPECT_EQ(keyOfName("ESC"), Key::kEscape);
  EXPECT_EQ(keyOfName("f3"), Key::kF3);
  for (const char* const name : {"", "no key", "aa", "escape "}) EXPECT_EQ(keyOfName(name), std::nullopt) << name;
}

TEST(StepPlay, FromTheTitleIntoTheFirstLevelWhereTheBallRolls) {
  const auto pictures = picturesOf({"wait 1", "tap enter", "wait 3", "press d", "wait 0.3", "wait 0.1"});
  EXPECT_TRUE(pictures[0] != pictures[2]) << "the title is left";
  EXPECT_TRUE(pictures[2] == pictures[3]) << "no time has passed";
  EXPECT_TRUE(pictures[3] != pictures[4]) << "the ball does not roll";
  EXPECT_TRUE(pictures[4] != pictures[5]) << "the ball does not roll on";
}

TEST(StepPlay, TheSameCommandsGiveTheSamePictures) {
  const std::vector<std::string> commands{"wait 3", "press d", "wait 0.5", "tap space", "wait 1.7"};
  const std::string level = "tests/determinism/golden/levels/hexahedron.level";
  EXPECT_TRUE(picturesOf(commands, level) == picturesOf(commands, level));
}

TEST(StepPlay, TimePassesOnlyInCommandsThatTakeTime) {
  const NewPlayer player;
  StepPlay play(optionsOf());
  EXPECT_EQ(play.obey("press d"), "ok 0.02") << "one frame has opened the title";
  EXPECT_EQ(play.obey("release d"), "ok 0.02");
  EXPECT_EQ(play.obey("wait 1"), "ok 1.02");
  EXPECT_EQ(play.obey("move 3 4"), "ok 1.02");
  EXPECT_EQ(play.obey("tap shift"), "ok 1.12");
  EXPECT_EQ(play.obey("tap shift 0.5"), "ok 1.62");
  EXPECT_EQ(play.obey("type abc"), "ok 1.67");
  EXPECT_EQ(play.obey("click 3 4"), "ok 1.68");
}

TEST(StepPlay, AWrongCommandIsAnsweredBySayingWhatIsRightAndDoesNothing) {
  const NewPlayer player;
  StepPlay play(optionsOf());
  const std::string keys = " is no key: name one, such as a, 7, space, enter, esc, arrow-left, shift or f1";
  EXPECT_EQ(play.obey("roll"),
            "error: 'roll' is no command: give press KEY, release KEY, tap KEY [SECONDS], type TEXT, move X Y, click X "
            "Y, scroll NOTCHES, wait SECONDS, shot FILE.png or quit");
  EXPECT_EQ(play.obey("press"), "error: ''" + keys);
  EXPECT_EQ(play.obey("tap hyper"), "error: 'hyper'" + keys);
  EXPECT_EQ(play.obey("press d a"), "error: leave out 'a', which is too much");
  EXPECT_EQ(play.obey("wait"), "error: SECONDS must be a number from 0 to 600");
  EXPECT_EQ(play.obey("wait nan"), "error: SECONDS must be a number from 0 to 600");
  EXPECT_EQ(play.obey("tap d 601"), "error: SECONDS must be a number from 0 to 600");
  EXPECT_EQ(play.obey("click 481 1"), "error: X must be a number from 0 to 480");
  EXPECT_EQ(play.obey("click 1 -1"), "error: Y must be a number from 0 to 270");
  EXPECT_EQ(play.obey("shot"), "error: name the file to write, such as shot 1.png");
  EXPECT_EQ(play.obey("shot /no/such/folder/1.png").substr(0, 7), "error: ");
  EXPECT_EQ(play.obey("quit now"), "error: leave out 'now', which is too much");
  EXPECT_TRUE(play.isOpen());
  EXPECT_EQ(play.obey("wait 0"), "ok 0.02");
}

TEST(StepPlay, QuittingAndTheMenuEndIt) {
  const NewPlayer player;
  StepPlay play(optionsOf());
  play.obey("quit");
  EXPECT_FALSE(play.isOpen());
  StepPlay other(optionsOf());
  other.obey("tap arrow-up");  // from Play to Quit
  EXPECT_TRUE(other.isOpen());
  other.obey("tap enter");
  EXPECT_FALSE(other.isOpen());
}

TEST(StepPlay, AKeyThatIsHeldRepeatsInAMenu) {
  const auto held = picturesOf({"press arrow-down", "wait 0.48", "wait 0.07"});
  EXPECT_TRUE(held[1] == picturesOf({"tap arrow-down", "wait 0.38"}).back()) << "it repeats too early";
  EXPECT_TRUE(held[2] == picturesOf({"tap arrow-down", "tap arrow-down", "tap arrow-down 0.35"}).back())
      << "after half a second it repeats 30 times a second";
}

void tapAll(StepPlay& play, std::initializer_list<const char*> keys) {
  for (const char* const key : keys) play.obey(std::string("tap ") + key);
}

// From the title to a new level of this name in the editor.
void openRoom(StepPlay& play) {
  tapAll(play, {"arrow-up", "arrow-up", "arrow-up", "arrow-up", "enter"});
  play.obey("type room");
  tapAll(play, {"arrow-down", "arrow-down", "enter"});
  play.obey("wait 0.2");
}

TEST(StepPlay, QuitEndsAlsoTheEditorWhichAsksNobody) {
  const NewPlayer player;
  StepPlay play(optionsOf());
  openRoom(play);
  play.obey("quit");
  EXPECT_FALSE(play.isOpen());
}

TEST(StepPlay, FromTheTitleIntoTheEditorAndBack) {
  const NewPlayer player;
  StepPlay play(optionsOf());
  const auto picture = [&] {
    EXPECT_EQ(play.obey("shot " + player.file("picture.png")).substr(0, 3), "ok ");
    return readText(player.file("picture.png"));
  };
  const auto tap = [&play](std::initializer_list<const char*> keys) { tapAll(play, keys); };
  const std::string title = picture();
  openRoom(play);
  EXPECT_TRUE(picture() != title);
  play.obey("press ctrl");
  tap({"s"});
  play.obey("release ctrl");
  EXPECT_NE(readText(player.folder / "platon/levels/room.level").find("# title: Room"), std::string::npos);
  tap({"esc", "arrow-up", "enter"});
  tap({"esc", "arrow-up", "enter"});
  EXPECT_FALSE(play.isOpen()) << "from the page of the editor to the title, whose last item quits";
}

TEST(StepPlay, TheMouseChoosesAsTheKeysDo) {
  EXPECT_TRUE(picturesOf({"click 100 142", "wait 0.2"}).back() ==
              picturesOf({"tap arrow-down", "tap enter", "wait 0.02"}).back());
}

TEST(StepPlay, ATextIsTypedAsByItsKeys) {
  const auto inTheAddress = [](std::vector<std::string> commands) {
    for (const char* const command : {"tap enter", "tap arrow-down", "tap arrow-down"})
      commands.insert(commands.begin(), command);
    return picturesOf(commands).back();
  };
  const std::string typed = inTheAddress({"type a-B"});
  EXPECT_TRUE(typed != inTheAddress({"wait 0.05"}));
  EXPECT_TRUE(typed == inTheAddress({"tap a 0", "tap minus 0", "press shift", "tap b 0.05", "release shift"}));
  EXPECT_TRUE(typed != inTheAddress({"type a-b"}));
}

// Presses and releases keys so that exactly these buttons of a player are held.
void hold(StepPlay& play, std::uint8_t& held, std::uint8_t wanted, const std::vector<std::string>& keys) {
  constexpr std::array<std::uint8_t, 4> kButtons{Input::kLeft, Input::kRight, Input::kJump, Input::kDown};
  for (std::size_t i = 0; i < kButtons.size(); ++i) {
    if ((held & kButtons[i]) == (wanted & kButtons[i])) continue;
    ASSERT_EQ(play.obey(((wanted & kButtons[i]) != 0 ? "press " : "release ") + keys[i]).substr(0, 3), "ok ");
  }
  held = wanted;
}

class CoopLevel : public testing::TestWithParam<const char*> {};

// As two friends play it: F2, and then each its keys. A press may come a tick early or late, which some ways do not
// bear; companions_test goes those exactly.
TEST_P(CoopLevel, IsFinishedByTwoOnOneKeyboard) {
  const NewPlayer player;
  const std::string level = GetParam();
  const RecordedWay way = readRecordedWay(readBytes("levels/data/ways" + level.substr(level.find('/')) + ".recording"));
  ASSERT_TRUE(way.level);
  StepPlay play(optionsOf("levels/data/" + level + ".level"));
  for (const char* const command : {"wait 3", "tap f2", "wait 2"}) ASSERT_EQ(play.obey(command).substr(0, 3), "ok ");
  // Both go back to the start in the same tick, as both come there in the recorded way.
  for (const char* const command : {"press r", "press slash", "wait 0.016667", "release r", "release slash"})
    ASSERT_EQ(play.obey(command).substr(0, 3), "ok ");
  std::uint8_t first = 0;
  std::uint8_t second = 0;
  for (std::size_t tick = 1; tick < way.inputs.size(); ++tick) {
    hold(play, first, way.inputs[tick].at(0).buttons, {"a", "d", "space", "s"});
    hold(play, second, way.inputs[tick].at(1).buttons, {"arrow-left", "arrow-right", "arrow-up", "arrow-down"});
    ASSERT_EQ(play.obey("wait 0.016667").substr(0, 3), "ok ");
  }
  play.obey("wait 1");
  play.obey("quit");
  EXPECT_NE(readText(player.file("platon/reached_levels")).find(hashText(way.level->hash)), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Shipped, CoopLevel,
                         testing::Values("hexahedron/06_hold_the_door", "tetrahedron/12_back_to_back"),
                         [](const auto& each) {
                           return std::string(each.param).substr(std::string(each.param).find('_') + 1);
                         });

}  // namespace
}  // namespace platon::step_play_test
