#include "client/desync/desync_report.h"

#include <gtest/gtest.h>

#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "platon/game/state_difference.h"
#include "tests/support/files.h"
#include "tests/support/flipped_bit.h"
#include "tests/support/resource_limit.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_levels.h"

namespace platon::desync_report_test {
namespace {

Game gameAfter(std::uint32_t ticks) {
  Game game(endlessLevel());
  const std::vector<Input> inputs = {Input{Input::kPresent}, Input{Input::kPresent | Input::kRight}};
  for (std::uint32_t i = 0; i < ticks; ++i) game.advance(inputs);
  return game;
}

Desync desyncOf(Game client, std::optional<Game> server) {
  return {5, 100, 103, 0xa, 0xb, std::move(client), std::move(server), {1, 2, 3}};
}

TEST(DesyncReport, NamesTheFirstDifferingField) {
  const Game server = gameAfter(104);
  Game client = server;
  ASSERT_TRUE(client.restore(flippedBit(client, "entity 0", "position")));
  const auto difference = firstDifference(client, server);
  ASSERT_TRUE(difference.has_value());
  const DesyncReport report = reportOf(desyncOf(client, server));
  EXPECT_EQ(
      report.summary,
      "round 5: desync at tick 103, last match at tick 100; first difference at tick 104: position of entity 0 is " +
          difference->left + " on the client, " + difference->right + " on the server");
  EXPECT_EQ(report.recording, (std::vector<std::uint8_t>{1, 2, 3}));
}

TEST(DesyncReport, ListsEveryFieldOfBothGamesAndMarksTheDifferingOnes) {
  const Game server = gameAfter(104);
  Game client = server;
  ASSERT_TRUE(client.restore(flippedBit(client, "entity 0", "position")));
  const std::string text = reportOf(desyncOf(client, server)).text;
  std::size_t marked = 0;
  for (const StateField& field : fieldsOf(server)) {
    const std::size_t at = text.find("\n  " + field.owner + " " + field.name + " ");
    const std::size_t markedAt = text.find("\n! " + field.owner + " " + field.name + " ");
    EXPECT_NE(at == std::string::npos, markedAt == std::string::npos) << field.owner << " " << field.name;
    marked += markedAt == std::string::npos ? 0 : 1;
  }
  EXPECT_EQ(marked, 1u) << text;
  EXPECT_NE(text.find("rules version"), std::string::npos);
}

TEST(DesyncReport, SaysThatTheServersStateDidNotArrive) {
  const DesyncReport report = reportOf(desyncOf(gameAfter(110), std::nullopt));
  EXPECT_EQ(report.summary, "round 5: desync at tick 103, last match at tick 100; the server's state did not arrive");
  EXPECT_EQ(report.text.find("server state"), std::string::npos);
}

TEST(DesyncReport, SaysThatTheStatesAreOfDifferentTicks) {
  const DesyncReport report = reportOf(desyncOf(gameAfter(103), gameAfter(110)));
  EXPECT_TRUE(report.summary.ends_with("; client state at tick 103, server state at tick 110")) << report.summary;
}

TEST(DesyncReport, SaysThatTheDifferenceIsGone) {
  const DesyncReport report = reportOf(desyncOf(gameAfter(110), gameAfter(110)));
  EXPECT_TRUE(report.summary.ends_with("; no difference at tick 110")) << report.summary;
}

// A server can cause a desync with every message.
TEST(DesyncReports, AtMostOneIsMadeInAMinuteAndEachIsTakenOnce) {
  DesyncReports reports;
  const auto add = [&reports](Time now) {
    reports.add(desyncOf(gameAfter(1), std::nullopt), now);
    return reports.take().has_value();
  };
  reports.add(std::nullopt, Time(0));
  EXPECT_FALSE(reports.take());
  EXPECT_TRUE(add(std::chrono::seconds(1)));
  EXPECT_FALSE(reports.take());
  EXPECT_FALSE(add(std::chrono::seconds(61) - std::chrono::microseconds(1)));
  EXPECT_TRUE(add(std::chrono::seconds(61)));
}

namespace fs = std::filesystem;

const DesyncReport kReport{"a desync", "details\n", {1, 2, 3}};

class DesyncFolderTest : public testing::Test {
 protected:
  std::string content(const char* name) const { return readText(folder_ / name); }

  const TemporaryFolder temporary_;
  const fs::path folder_ = temporary_ / "deep";
};

TEST_F(DesyncFolderTest, WritesNothingWithoutAPath) { EXPECT_EQ(DesyncFolder(fs::path()).write(kReport), "a desync"); }

TEST_F(DesyncFolderTest, WritesReportAndRecording) {
  EXPECT_EQ(DesyncFolder(folder_).write(kReport), "a desync; see " + (folder_ / "desync-1.txt").string());
  EXPECT_EQ(content("desync-1.txt"),
            "details\n\nRecording of the client's game: " + (folder_ / "desync-1.recording").string() + "\n");
  EXPECT_EQ(content("desync-1.recording"), "\1\2\3");
}

TEST_F(DesyncFolderTest, WritesAtMostTenReports) {
  for (int i = 0; i < DesyncFolder::kMaxReports; ++i) DesyncFolder(folder_).write(kReport);
  const std::string said = DesyncFolder(folder_).write({"a desync again", "", {}});
  EXPECT_TRUE(said.starts_with("a desync again; not written: ")) << said;
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 2 * DesyncFolder::kMaxReports);
  EXPECT_EQ(content("desync-10.recording"), "\1\2\3");
}

TEST_F(DesyncFolderTest, NeverOverwritesARecording) {
  DesyncFolder(folder_).write(kReport);
  fs::remove(folder_ / "desync-1.txt");
  EXPECT_EQ(DesyncFolder(folder_).write({"again", "", {4}}), "again; see " + (folder_ / "desync-2.txt").string());
  EXPECT_EQ(content("desync-1.recording"), "\1\2\3");
  EXPECT_EQ(content("desync-2.recording"), "\4");
}

TEST_F(DesyncFolderTest, OnAFullDiskNoPartOfAReportIsLeft) {
  const FullDisk full(2);
  const std::string said = DesyncFolder(folder_).write(kReport);
  EXPECT_EQ(said, "a desync; cannot write " + (folder_ / "desync-1.recording").string() + ": File too large");
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(DesyncFolderTest, NamesTheErrorWhenItCannotWrite) {
  writeText(folder_, "a file");
  const std::string said = DesyncFolder(folder_).write(kReport);
  EXPECT_TRUE(said.ends_with(": Not a directory")) << said;
}

}  // namespace
}  // namespace platon::desync_report_test
