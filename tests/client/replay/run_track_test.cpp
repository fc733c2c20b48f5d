#include "client/replay/run_track.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "client/replay/run_list.h"
#include "platon/game/recorder.h"
#include "platon/game/recording_format.h"
#include "tests/client/replay/followed_game.h"
#include "tests/client/replay/replay_of.h"
#include "tests/shared/game/forged_recording.h"
#include "tests/shared/game/played_game.h"
#include "tests/shared/game/recorded_game.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon::run_track_test {
namespace {

// One player runs over the edge to the goal on the next face.
FollowedGame overTheEdge() {
  FollowedGame followed(cubeLevel("0 0 -180 0", {"-240 -200 240 -200", "-240 -200 240 -200"}, "1 0 -190"));
  followed.hold(30, 0);
  followed.holdToGoal(400, Input::kRight);
  return followed;
}

TEST(FaceVisits, TheFirstFaceIsNoneAndEachOtherCountsOnce) {
  FaceVisits visits;
  EXPECT_FALSE(visits.enters(3));
  EXPECT_FALSE(visits.enters(3));
  EXPECT_TRUE(visits.enters(0));
  EXPECT_FALSE(visits.enters(3));
  EXPECT_TRUE(visits.enters(19));
  EXPECT_FALSE(visits.enters(0));
}

TEST(RunTrack, HasThePlaceAfterEveryTickOfTheAttempt) {
  const FollowedGame followed = overTheEdge();
  ASSERT_TRUE(followed.run);
  const auto replay = replayOf(followed.run->recording);
  const auto track = trackOf(*replay);
  ASSERT_TRUE(track);
  ASSERT_EQ(track->places.size(), track->ticks + 1U);
  const std::uint32_t before = replay->ticks() - track->ticks;
  for (std::uint32_t ticks = 0; ticks <= track->ticks; ++ticks) {
    const EntityState entity = replay->gameAfter(before + ticks).world().entities()[0];
    ASSERT_EQ(track->places[ticks].position, entity.position) << ticks;
    ASSERT_EQ(track->places[ticks].part, entity.part) << ticks;
  }
  EXPECT_EQ(replay->gameAfter(before).player(0).startedAt, 0U);
  EXPECT_NE(replay->gameAfter(before + 1).player(0).startedAt, 0U);
}

TEST(RunTrack, ASplitIsTheTickAfterWhichThePlayerIsOnTheNewFace) {
  const FollowedGame followed = overTheEdge();
  const auto track = trackOf(*replayOf(followed.run->recording));
  ASSERT_TRUE(track);
  ASSERT_EQ(track->splits.size(), 1U);
  const Split split = track->splits.front();
  EXPECT_EQ(split.face, 1U);
  EXPECT_EQ(track->places[split.ticks].part, 1U);
  EXPECT_EQ(track->places[split.ticks - 1].part, 0U);
  EXPECT_EQ(*track->splitOf(1), split);
  EXPECT_EQ(track->splitOf(0), nullptr);
  EXPECT_EQ(track->splitOf(4), nullptr);
}

TEST(RunTrack, TheGhostMovesInTimeAndStaysAtTheGoal) {
  const FollowedGame followed = overTheEdge();
  const auto track = trackOf(*replayOf(followed.run->recording));
  ASSERT_TRUE(track);
  EXPECT_FALSE(track->at(0, 1).now.present);
  const InterpolatedPlayer third = track->at(3, 0.25);
  EXPECT_EQ(third.before.position, track->places[2].position);
  EXPECT_EQ(third.now.position, track->places[3].position);
  EXPECT_EQ(third.fraction, 0.25);
  for (const std::uint32_t later : {1U, 100U}) {
    const InterpolatedPlayer after = track->at(track->ticks + later, 0.25);
    EXPECT_EQ(after.before.position, track->places.back().position);
    EXPECT_EQ(after.now.position, track->places.back().position);
  }
}

TEST(RunTrack, TheFirstAndTheLastTickAreInterpolated) {
  const FollowedGame followed = overTheEdge();
  const auto track = trackOf(*replayOf(followed.run->recording));
  ASSERT_TRUE(track);
  for (const std::uint32_t ticks : {1U, track->ticks}) {
    ASSERT_NE(track->places[ticks - 1].position, track->places[ticks].position);
    const InterpolatedPlayer shown = track->at(ticks, 0.75);
    EXPECT_EQ(shown.before.position, track->places[ticks - 1].position) << ticks;
    EXPECT_EQ(shown.now.position, track->places[ticks].position) << ticks;
    EXPECT_EQ(shown.fraction, 0.75) << ticks;
  }
}

// A player who joins with a button held is not there before the first tick.
TEST(RunTrack, APlayerWhoStaysOnItsFirstFaceHasNoSplit) {
  for (const int waits : {0, 30}) {
    FollowedGame followed(cubeLevel("1 0 -180 0", {"", "-240 -200 240 -200"}, "1 100 -190"));
    followed.hold(waits, 0);
    followed.holdToGoal(400, Input::kRight);
    ASSERT_TRUE(followed.run);
    const auto track = trackOf(*replayOf(followed.run->recording));
    ASSERT_TRUE(track);
    EXPECT_EQ(track->places.front().present, waits != 0);
    EXPECT_TRUE(track->splits.empty()) << waits;
  }
}

TEST(RunTrack, ItsComputationCanBeStopped) {
  const auto replay = replayOf(overTheEdge().run->recording);
  std::stop_source stop;
  EXPECT_TRUE(trackOf(*replay, stop.get_token()));
  stop.request_stop();
  EXPECT_FALSE(trackOf(*replay, stop.get_token()));
}

TEST(RunTrack, ARecordingWithoutAnArrivalInItsLastTickIsNoRun) {
  EXPECT_FALSE(trackOf(*replayOf(recordGame(100, 60).recording)));
  Recorder recorder{Game(recordedLevel())};
  recorder.finish(Game(recordedLevel()));
  EXPECT_FALSE(trackOf(*replayOf(recorder.takeBytes())));
}

TEST(RunTrack, AnAttemptThatBeganBeforeTheRecordingIsNoRun) {
  FollowedGame followed(cubeLevel("0 0 -180 0", {"-240 -200 240 -200"}, "0 100 -190"));
  followed.hold(10, Input::kRight);
  Recorder recorder(followed.game);
  const std::vector<Input> inputs{{Input::kPresent | Input::kRight}};
  while (!followed.time) {
    followed.advance(inputs);
    recorder.record(inputs, followed.game);
  }
  recorder.finish(followed.game);
  EXPECT_FALSE(trackOf(*replayOf(recorder.takeBytes())));
}

class TrackFileTest : public testing::Test {
 protected:
  TrackFileTest() {
    followed_.hold(30, 0);
    followed_.holdToGoal(300, Input::kRight);
  }
  void write(const std::vector<std::uint8_t>& bytes) {
    writeText(file_, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  }
  std::string fault(const Level* level = nullptr) const {
    const auto track = readTrack(file_, level);
    const auto* const text = std::get_if<std::string>(&track);
    return text == nullptr ? "" : text->substr(file_.string().size());
  }

  const TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_ / "run";
  FollowedGame followed_{cubeLevel("0 0 -180 0", {"-240 -200 240 -200"}, "0 100 -190")};
};

TEST_F(TrackFileTest, ReadsARunOfItsLevel) {
  write(followed_.run->recording);
  const auto track = readTrack(file_, &followed_.game.level());
  ASSERT_TRUE(std::holds_alternative<RunTrack>(track));
  EXPECT_EQ(std::get<RunTrack>(track).ticks, *followed_.time);
  EXPECT_EQ(fault(), "");
}

TEST_F(TrackFileTest, SaysWhyAFileIsNoRun) {
  EXPECT_EQ(fault().substr(0, 17), ": cannot be read:");
  write(followed_.run->recording);
  Level forged = followed_.game.level();  // with the same hash
  forged.text += "# another";
  EXPECT_EQ(fault(&forged), ": is a recording of another level");
  Recorder recorder{Game(followed_.game.sharedLevel())};
  recorder.finish(Game(followed_.game.sharedLevel()));
  write(recorder.takeBytes());
  EXPECT_EQ(fault(), ": is no run: it does not end with a player at the goal");
}

// Such a file verifies, and has a time of a few ticks.
TEST_F(TrackFileTest, ARecordingThatBeginsBesideTheGoalIsNoRun) {
  write(forgedRun(followed_.game.sharedLevel(), units(60)));
  EXPECT_EQ(fault(), ": is no run: its player does not begin at the start of the level, at rest");
  const RecordingFacts facts = readRecordingFacts(file_);
  EXPECT_EQ(facts.note, "") << "it can be watched";
  EXPECT_EQ(facts.ticks, std::nullopt);
  EXPECT_EQ(": " + facts.noRun, fault());
}

TEST_F(TrackFileTest, ARunThatIsLongerThanAnyWhichTheGameKeepsIsRefused) {
  for (const auto& [wait, allowed] :
       {std::pair(RunCutter::kMaxTicks - 200, true), std::pair(RunCutter::kMaxTicks, false)}) {
    PlayedGame played(followed_.game.sharedLevel());
    Recorder recorder(played.game, kMaxCheckpointTicks);
    const auto hold = [&](std::uint8_t buttons) {
      const Input input{static_cast<std::uint8_t>(buttons | Input::kPresent)};
      played.run(1, buttons);
      recorder.record({&input, 1}, played.game);
    };
    hold(Input::kJump);
    for (std::size_t tick = 0; tick < wait; ++tick) hold(0);
    for (int tick = 0; tick < 199 && played.player().arrived == 0; ++tick) hold(Input::kRight);
    ASSERT_EQ(played.player().arrived, 1);
    recorder.finish(played.game);
    write(recorder.takeBytes());
    EXPECT_EQ(fault(), allowed ? "" : ": is a run of more than 30 minutes, too long for a ghost");
  }
}

}  // namespace
}  // namespace platon::run_track_test
