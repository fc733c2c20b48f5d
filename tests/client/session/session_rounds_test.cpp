// Votes, the end of a round, and the levels of the next ones.
#include "client/session/session.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "tests/net/support/pressing.h"
#include "tests/net/support/session_network.h"
#include "tests/support/test_levels.h"

namespace platon::session_rounds_test {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr std::uint64_t kSeed = 20261201;

LinkQuality quality() {
  LinkQuality quality;
  quality.delayMs = 30;
  return quality;
}

/// Levels in memory that outlive a session.
class KeptLevels : public LevelStore {
 public:
  std::vector<std::uint64_t> newest(std::size_t count) const override {
    return {hashes_.end() - static_cast<std::ptrdiff_t>(std::min(count, hashes_.size())), hashes_.end()};
  }
  std::shared_ptr<const Level> load(std::uint64_t hash) override {
    const auto found = levels.find(hash);
    return found == levels.end() ? nullptr : found->second;
  }
  void keep(const Level& level) override { add(std::make_shared<Level>(level)); }

  void add(const std::shared_ptr<const Level>& level) {
    hashes_.push_back(level->hash);
    levels[level->hash] = level;
  }
  std::map<std::uint64_t, std::shared_ptr<const Level>> levels;

 private:
  std::vector<std::uint64_t> hashes_;
};

// The messages of this type that the session has queued; the others are dropped.
template <class Message>
std::vector<Message> sentBy(Session& session) {
  std::vector<Message> found;
  for (const OutgoingMessage& message : session.takeOutgoing()) {
    const auto decoded = decodeToServer(message.bytes);
    if (decoded && std::holds_alternative<Message>(*decoded)) found.push_back(std::get<Message>(*decoded));
  }
  return found;
}

void receive(Session& session, const auto& message) { session.receive(encode(message), Time(0)); }

// In chunks, as a server sends it.
void receiveLevel(Session& session, const Level& level) {
  for (std::size_t at = 0; at < level.text.size(); at += kChunkBytes) {
    const std::string part = level.text.substr(at, kChunkBytes);
    receive(session, LevelChunk{level.hash,
                                static_cast<std::uint32_t>(level.text.size()),
                                static_cast<std::uint32_t>(at),
                                {part.begin(), part.end()}});
  }
}

Welcome welcomeTo(const Level& level) { return {0, 1, level.hash, 4, kTicksPerSecond, ""}; }

TEST(SessionVote, AMajorityMovesOnAndEverybodySeesTheCount) {
  SessionNetwork network({endlessLevel(), cornerLevel()}, kSeed);
  for (std::uint64_t i = 0; i < 3; ++i) network.join(quality(), pressing(kSeed + i));
  network.run(seconds(2));
  EXPECT_EQ(network.session(2).voteCount().votes, 0u);
  network.session(0).toggleVote();
  network.run(seconds(1));
  for (const std::size_t client : {0u, 1u, 2u}) {
    EXPECT_EQ(network.session(client).voteCount(), (VoteCount{1, 1, 3}));
    EXPECT_EQ(network.session(client).wishesNext(), client == 0);
    EXPECT_FALSE(network.session(client).roundEnd());
  }
  network.session(1).toggleVote();
  network.run(seconds(1));
  for (const std::size_t client : {0u, 1u, 2u}) ASSERT_TRUE(network.session(client).roundEnd());
  network.run(seconds(6));
  for (const std::size_t client : {0u, 1u, 2u}) {
    ASSERT_TRUE(network.session(client).round());
    EXPECT_EQ(network.session(client).round()->id(), 2u);
    EXPECT_EQ(network.session(client).round()->prediction().confirmed().level().hash, cornerLevel()->hash);
    EXPECT_EQ(network.session(client).voteCount(), VoteCount());
    EXPECT_FALSE(network.session(client).wishesNext());
    EXPECT_EQ(network.session(client).roundStatistics().desyncs, 0u);
  }
}

TEST(SessionVote, AVoteThatIsTakenBackIsNotCounted) {
  SessionNetwork network({endlessLevel()}, kSeed);
  for (std::uint64_t i = 0; i < 2; ++i) network.join(quality(), pressing(kSeed + i));
  network.run(seconds(2));
  network.session(0).toggleVote();
  network.run(seconds(1));
  EXPECT_EQ(network.session(1).voteCount().votes, 1u);
  network.session(0).toggleVote();
  network.run(seconds(2));
  EXPECT_EQ(network.session(1).voteCount().votes, 0u);
  EXPECT_FALSE(network.session(0).wishesNext());
}

TEST(SessionVote, ANewcomerSeesTheCount) {
  SessionNetwork network({endlessLevel()}, kSeed);
  for (std::uint64_t i = 0; i < 3; ++i) network.join(quality(), pressing(kSeed + i));
  network.run(seconds(2));
  network.session(0).toggleVote();
  network.run(seconds(2));
  network.join(quality(), pressing(kSeed));
  network.run(seconds(2));
  EXPECT_EQ(network.session(3).voteCount(), (VoteCount{1, 1, 4}));
}

TEST(SessionVote, AResumedPlayerHasNotVoted) {
  SessionNetwork network({endlessLevel()}, kSeed);
  for (std::uint64_t i = 0; i < 3; ++i) network.join(quality(), pressing(kSeed + i));
  network.run(seconds(2));
  network.session(0).toggleVote();
  network.run(seconds(1));
  network.disconnect(0, milliseconds(100));
  network.run(seconds(1));
  EXPECT_EQ(network.session(1).voteCount().votes, 0u);
  network.resume(0);
  network.run(seconds(2));
  EXPECT_FALSE(network.session(0).wishesNext());
  EXPECT_EQ(network.session(1).voteCount().votes, 0u);
}

TEST(SessionVote, WithoutARoundOrAfterItsEndNothingIsSent) {
  Session session("x", Time(0));
  session.toggleVote();
  EXPECT_TRUE(sentBy<Vote>(session).empty());
  receive(session, welcomeTo(*endlessLevel()));
  session.toggleVote();
  EXPECT_TRUE(sentBy<Vote>(session).empty()) << "its level has not come";
  receiveLevel(session, *endlessLevel());
  session.toggleVote();
  session.toggleVote();
  EXPECT_EQ(sentBy<Vote>(session), (std::vector<Vote>{{1, true}, {1, false}}));
  receive(session, RoundEnd{1, 10, endlessLevel()->hash});
  session.toggleVote();
  EXPECT_TRUE(sentBy<Vote>(session).empty());
  EXPECT_FALSE(session.wishesNext());
}

TEST(SessionVote, ACountOfAnotherRoundIsIgnored) {
  Session::Memory memory;
  memory.levels = {endlessLevel()};
  Session session("x", Time(0), memory);
  receive(session, welcomeTo(*endlessLevel()));
  receive(session, VoteCount{2, 1, 1});
  EXPECT_EQ(session.voteCount(), VoteCount());
  receive(session, VoteCount{1, 1, 2});
  EXPECT_EQ(session.voteCount(), (VoteCount{1, 1, 2}));
}

TEST(SessionRoundEnd, NamesTheNextLevelAsItCanBeSeenAndTheLastOneCounts) {
  Session::Memory memory;
  memory.levels = {endlessLevel()};
  Session session("x", Time(0), memory);
  const std::uint64_t level = endlessLevel()->hash;
  receive(session, welcomeTo(*endlessLevel()));
  receive(session, RoundEnd{1, 10, level, "A\u200b  b", 300, LevelBest{7, "\u3164 Ann", true}});
  ASSERT_TRUE(session.roundEnd());
  EXPECT_EQ(*session.roundEnd(), (RoundEnd{1, 10, level, "A b", 300, LevelBest{7, "Ann", true}}));
  receive(session, RoundEnd{1, 10, level, "C", 300, std::nullopt});
  EXPECT_EQ(session.roundEnd()->nextTitle, "C");
  EXPECT_EQ(session.roundEnd()->best, std::nullopt);
}

TEST(SessionRoundEnd, ANewcomerInThePauseGetsBothLevelsAndTheCountdown) {
  SessionNetwork network({endlessLevel(), cornerLevel()}, kSeed);
  network.join(quality(), pressing(kSeed));
  network.run(seconds(2));
  network.match().endRoundNow();
  network.run(seconds(1));
  network.join(quality(), pressing(kSeed));
  network.run(seconds(1));
  ASSERT_TRUE(network.session(1).round());
  EXPECT_EQ(network.session(1).round()->id(), 1u);
  ASSERT_TRUE(network.session(1).roundEnd());
  EXPECT_EQ(network.session(1).roundEnd()->tick, network.session(0).roundEnd()->tick);
  EXPECT_EQ(network.session(1).memory().levels.size(), 2u);
  network.run(seconds(4));
  ASSERT_TRUE(network.session(1).round());
  EXPECT_EQ(network.session(1).round()->id(), 2u);
}

// What the first round has learned of the connection is not learned again.
TEST(SessionRoundEnd, TheNextRoundBeginsWithTheLeadOfTheLast) {
  SessionNetwork network({endlessLevel(), cornerLevel()}, kSeed);
  LinkQuality jittery = quality();
  jittery.jitterMs = 80;
  network.join(jittery, pressing(kSeed));
  const auto round = [&] { return network.session(0).round(); };
  for (int ms = 0; ms < 5000 && !round(); ++ms) network.run(milliseconds(1));
  ASSERT_TRUE(round());
  const double first = round()->clock().lead();
  network.run(seconds(10));
  network.match().endRoundNow();
  double last = 0;
  for (int ms = 0; ms < 10000 && round() && round()->id() == 1; ++ms) {
    last = round()->clock().lead();
    network.run(milliseconds(1));
  }
  ASSERT_TRUE(round());
  EXPECT_EQ(round()->id(), 2u);
  EXPECT_GT(std::abs(last - first), 1) << "the law would be empty";
  EXPECT_NEAR(round()->clock().lead(), last, 0.1);
}

// The request for the next level must not displace the text of the present one.
TEST(SessionRoundEnd, TheNextLevelIsRequestedWhenThePresentOneHasCome) {
  Session session("x", Time(0));
  receive(session, welcomeTo(*endlessLevel()));
  receive(session, RoundEnd{1, 10, cornerLevel()->hash});
  EXPECT_TRUE(sentBy<LevelRequest>(session).empty());
  receiveLevel(session, *endlessLevel());
  EXPECT_TRUE(session.round());
  EXPECT_EQ(sentBy<LevelRequest>(session), std::vector{LevelRequest{cornerLevel()->hash}});
}

TEST(SessionLevels, StoredLevelsAreAnnouncedAndNotRequested) {
  Session::Memory memory;
  const auto store = std::make_shared<KeptLevels>();
  store->add(endlessLevel());
  store->add(cornerLevel());
  memory.store = store;
  Session session("x", Time(0), memory);
  const std::vector<Hello> hello = sentBy<Hello>(session);
  ASSERT_EQ(hello.size(), 1u);
  EXPECT_EQ(hello[0].levels, (std::vector{endlessLevel()->hash, cornerLevel()->hash}));
  receive(session, welcomeTo(*endlessLevel()));
  EXPECT_TRUE(session.round());
  receive(session, RoundEnd{1, 10, cornerLevel()->hash});
  EXPECT_TRUE(sentBy<LevelRequest>(session).empty());
  receive(session, RoundStart{2, cornerLevel()->hash});
  ASSERT_TRUE(session.round());
  EXPECT_EQ(session.round()->id(), 2u);
  EXPECT_EQ(session.memory().levels.size(), 2u) << "they are not loaded again";
}

TEST(SessionLevels, AnAnnouncedLevelThatIsLostIsRequested) {
  Session::Memory memory;
  const auto store = std::make_shared<KeptLevels>();
  store->add(endlessLevel());
  memory.store = store;
  Session session("x", Time(0), memory);
  store->levels.clear();
  receive(session, welcomeTo(*endlessLevel()));
  EXPECT_FALSE(session.round());
  EXPECT_EQ(sentBy<LevelRequest>(session), std::vector{LevelRequest{endlessLevel()->hash}});
  receiveLevel(session, *endlessLevel());
  EXPECT_TRUE(session.round());
}

TEST(SessionLevels, AReceivedLevelIsStored) {
  Session::Memory memory;
  const auto store = std::make_shared<KeptLevels>();
  memory.store = store;
  Session session("x", Time(0), memory);
  receive(session, welcomeTo(*endlessLevel()));
  receiveLevel(session, *endlessLevel());
  EXPECT_EQ(store->newest(8), std::vector{endlessLevel()->hash});
  EXPECT_EQ(session.memory().store, store) << "for the next session";
}

TEST(SessionLevels, ALevelIsTakenOnce) {
  Session::Memory memory;
  const auto store = std::make_shared<KeptLevels>();
  memory.store = store;
  Session session("x", Time(0), memory);
  receive(session, welcomeTo(*endlessLevel()));
  for (int times = 0; times < 2; ++times) receiveLevel(session, *endlessLevel());
  EXPECT_EQ(store->newest(8).size(), 1u);
  EXPECT_EQ(session.memory().levels.size(), 1u);
}

TEST(SessionLevels, AtMostAsManyLevelsAreAnnouncedAsAMessageHolds) {
  Session::Memory memory;
  const auto store = std::make_shared<KeptLevels>();
  for (int i = 0; i < 20; ++i) {
    auto level = std::make_shared<Level>(*endlessLevel());
    level->hash = static_cast<std::uint64_t>(i);
    store->add(level);
  }
  memory.levels = {endlessLevel(), std::make_shared<Level>(*store->load(19))};
  memory.store = store;
  Session session("x", Time(0), memory);
  const std::vector<Hello> hello = sentBy<Hello>(session);
  ASSERT_EQ(hello.size(), 1u);
  EXPECT_EQ(hello[0].levels.size(), kMaxLevelsKnown);
  EXPECT_EQ(hello[0].levels[0], endlessLevel()->hash);
  EXPECT_EQ(std::count(hello[0].levels.begin(), hello[0].levels.end(), 19u), 1);
}

}  // namespace
}  // namespace platon::session_rounds_test
