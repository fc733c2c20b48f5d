// What files of release 0.1.0, written by its own code, are for the programs of this release: the table of
// docs/architecture.md#files-of-an-older-release. Of the recordings, one is by version 7 of the rules and one by
// version 3. Never write these files anew.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <variant>

#include "client/files/server_files.h"
#include "client/files/settings_file.h"
#include "client/lobby/remembered.h"
#include "client/lobby/shipped_levels.h"
#include "client/replay/level_ghosts.h"
#include "client/replay/replay.h"
#include "client/replay/run_store.h"
#include "platon/game/game.h"
#include "platon/game/level.h"
#include "protocol/hash_text.h"
#include "protocol/transport/server_identity.h"
#include "server/admin/bans.h"
#include "server/times/best_times.h"
#include "tests/support/files.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace platon::older_files_test {
namespace {

namespace fs = std::filesystem;

const fs::path kOlder = "tests/compatibility/0.1.0";
constexpr std::uint32_t kOlderRules = 7;
constexpr bool kSameRules = kRulesVersion == kOlderRules;
constexpr std::uint32_t kRunTicks = 228;

// The levels of 0.1.0, and the hashes that it gave them: best times, runs and kept levels have these names.
const std::map<std::string, std::uint64_t> kLevels{{"elements.level", 0x2f036d4098d0c83d},
                                                   {"first_steps.level", 0x069f8c48aaa16d7a},
                                                   {"run_and_jump.level", 0x31305b9e599e880f}};

std::shared_ptr<const Level> levelIn(const std::string& file) { return loadLevel(readText(kOlder / file)).level; }

ServerAddress exampleServer() { return parseServerAddress("play.example.org"); }

// A copy of an older file, which a program may write.
fs::path copyOf(const std::string& name, const fs::path& target) {
  fs::create_directories(target.parent_path());
  fs::copy_file(kOlder / name, target);
  return target;
}

std::optional<std::string> faultOfReplay(const fs::path& file) {
  const auto read = readReplay(file);
  const std::string* const fault = std::get_if<std::string>(&read);
  return fault == nullptr ? std::nullopt : std::optional(*fault);
}

TEST(OlderFiles, LevelsLoadAndKeepTheirHashes) {
  for (const auto& [file, hash] : kLevels) {
    const LevelResult result = loadLevel(readText(kOlder / file));
    ASSERT_TRUE(result.level) << file << ": " << format(file, result.diagnostics.front());
    EXPECT_EQ(hashText(result.level->hash), hashText(hash)) << file;
    const ProcessResult checked = runProcess(platonCommand("platon-level", {"check", (kOlder / file).string()}));
    EXPECT_EQ(checked.exitCode, 0) << checked.errors;
  }
}

TEST(OlderFiles, ALevelThatAServerSentIsTakenFromTheCache) {
  const TemporaryFolder folder;
  copyOf("elements.level", folder / "play.example.org_7777/2f036d4098d0c83d");
  EXPECT_TRUE(LevelCache(folder.path(), exampleServer()).load(kLevels.at("elements.level")));
}

TEST(OlderFiles, RecordingsArePlayedByTheSameRulesAndElseSayWhatTheyAre) {
  const fs::path same = kOlder / "run.recording";
  const fs::path older = kOlder / "rules_3.recording";
  EXPECT_EQ(faultOfReplay(same), kSameRules ? std::nullopt : std::optional(same.string() + ": " + otherRulesText(7)));
  EXPECT_EQ(faultOfReplay(older), older.string() + ": " + otherRulesText(3));
  EXPECT_EQ(runProcess(platonCommand("platon-sim", {"verify", same.string()})).exitCode, kSameRules ? 0 : 3);
  const ProcessResult verified = runProcess(platonCommand("platon-sim", {"verify", older.string()}));
  EXPECT_EQ(verified.exitCode, 3);
  EXPECT_EQ(verified.errors, older.string() +
                                 ": byte 8: recorded with version 3 of the rules, but this program has version " +
                                 std::to_string(kRulesVersion) + "\n");
}

TEST(OlderFiles, RunsAreCompared) {
  const TemporaryFolder folder;
  const auto level = levelIn("run_and_jump.level");
  const std::string name = hashText(level->hash) + "-7-" + std::to_string(kRunTicks) + ".recording";
  copyOf("run.recording", folder / name);
  const RunStore runs(folder.path());
  const std::optional<StoredRun> best = runs.best(*level);
  ASSERT_EQ(best.has_value(), kSameRules);
  if (best) EXPECT_EQ(best->ticks, kRunTicks);
  EXPECT_EQ(runs.all().size(), 1u) << "kept in any case";
}

TEST(OlderFiles, GhostsRunAlongByTheSameRulesAndElseSayWhatTheyAre) {
  const TemporaryFolder folder;
  copyOf("run.recording", folder / "Ann.recording");
  copyOf("rules_3.recording", folder / "Ben.recording");
  std::vector<std::string> faults;
  EXPECT_EQ(ghostsIn(folder.path(), *levelIn("run_and_jump.level"), 3, faults).size(), kSameRules ? 1u : 0u);
  faults.clear();
  EXPECT_TRUE(ghostsIn(folder.path(), *levelIn("first_steps.level"), 3, faults).empty());
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_TRUE(faults[0].ends_with(otherRulesText(3))) << faults[0];
}

TEST(OlderFiles, BestTimesAreTakenOverAndThoseOfOlderRulesAreKept) {
  const TemporaryFolder folder;
  const fs::path file = copyOf("best_times", folder / "best_times");
  auto read = readBestTimes(file.string());
  ASSERT_TRUE(std::holds_alternative<BestTimes>(read)) << std::get<1>(read).front();
  const std::uint64_t level = kLevels.at("run_and_jump.level");
  EXPECT_EQ(std::get<BestTimes>(read).find({level, 7})->time, (BestTime{240, "Zoë of old"}));
  EXPECT_EQ(std::get<BestTimes>(read).find({level, 6})->time, (BestTime{260, "Ann"}));
  // A newer time, and nothing else, changes.
  BestTimes newer;
  newer.offer({level, kRulesVersion}, {{90, "New"}, *parseUtcTime("2036-01-01")});
  EXPECT_EQ(addBestTimes(file.string(), newer.text()), "");
  EXPECT_EQ(std::get<BestTimes>(readBestTimes(file.string())).find({level, 6})->time, (BestTime{260, "Ann"}));
  // The list of levels shows a time of older rules as such.
  const ShippedLevel shipped{"", levelIn("run_and_jump.level"), 0};
  const LevelEntry entry = entriesOf({shipped}, (kOlder / "best_times").string(), ReachedLevels({})).front();
  EXPECT_EQ(entry.bestTicks, kSameRules ? std::optional(240u) : std::nullopt);
  EXPECT_EQ(entry.olderTicks, kSameRules ? 260u : 240u);
}

TEST(OlderFiles, ReachedLevelsAreTakenOver) {
  const ReachedLevels reached(kOlder / "reached_levels");
  EXPECT_TRUE(reached.has(kLevels.at("run_and_jump.level")));
}

TEST(OlderFiles, SettingsAndKeysOfControlsAreTakenOver) {
  const TemporaryFolder folder;
  copyOf("settings", folder / "settings");
  SettingsFile file(folder.path());
  const Settings settings = file.load();
  EXPECT_EQ(file.fault(), "");
  EXPECT_EQ(settings.zoom, 1.5);
  EXPECT_EQ(settings.uiScale, 1.25);
  EXPECT_EQ(settings.controls, ControlFrame::kScreen);
  EXPECT_EQ(settings.comfort.turnRate, 5);
  EXPECT_TRUE(settings.comfort.reducedMotion);
  EXPECT_EQ(settings.volume, 35);
  EXPECT_FALSE(settings.chat);
  EXPECT_TRUE(settings.faceNumbers);
  EXPECT_EQ(settings.gameSpeed, 70);
  // Saving loses no line: each one is written again, or a newer program has dropped it and keeps it as unknown.
  file.save(settings);
  const std::string saved = readText(folder / "settings");
  for (const char* const line : {"zoom 1.5\n", "controls screen\n", "key vote v pad-y\n", "key say t\n"}) {
    EXPECT_NE(saved.find(line), std::string::npos) << line;
  }
}

TEST(OlderFiles, TheKeyOfAServerAndTheServersThatAPlayerKnowsAreTakenOver) {
  const CryptoKey key = readKeyFile((kOlder / "server.key").string()).publicKey();
  const KnownServers known(kOlder / "known_servers");
  EXPECT_EQ(known.find(exampleServer()), key);
  EXPECT_EQ(known.find(parseServerAddress("[2001:db8::1]:7778")), key);
  const std::vector<ServerAddress> recent = RecentServers(kOlder / "recent_servers").list();
  EXPECT_EQ(recent, (std::vector<ServerAddress>{parseServerAddress("[2001:db8::1]:7778"), exampleServer()}));
}

TEST(OlderFiles, BansAreTakenOver) {
  const auto read = readBanFile((kOlder / "bans").string());
  ASSERT_TRUE(std::holds_alternative<BanList>(read)) << std::get<1>(read).front();
  const BanList& bans = std::get<BanList>(read);
  EXPECT_EQ(bans.size(), 3u);
  const UtcTime now = *parseUtcTime("2027-01-01");
  const Ban* const ban = bans.find(*IpAddress::parse("203.0.113.9"), now);
  ASSERT_NE(ban, nullptr);
  EXPECT_EQ(ban->reason, "floods the server");
  EXPECT_NE(bans.find(*IpAddress::parse("192.0.2.7"), now), nullptr);
  EXPECT_EQ(bans.text(), readText(kOlder / "bans"));
}

TEST(OlderFiles, AServerStartsWithTheConfigurationOfAnOlderOne) {
  const TemporaryFolder folder;
  for (const auto& file : fs::directory_iterator(kOlder)) fs::copy(file.path(), folder / file.path().filename());
  const ProcessResult checked =
      runProcess(platonCommand("platon-server", {"--check-config", "--config", (folder / "server.toml").string()}));
  EXPECT_EQ(checked.exitCode, 0) << checked.errors;
}

}  // namespace
}  // namespace platon::older_files_test
