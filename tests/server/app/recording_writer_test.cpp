#include "server/app/recording_writer.h"

#include <gtest/gtest.h>

#include <future>
#include <memory>
#include <mutex>
#include <thread>

#include "tests/support/wait_until.h"

namespace platon::recording_writer_test {
namespace {

using namespace std::chrono_literals;

constexpr RecordingWriter::Time kTime{1h};

RecordingPiece piece(std::uint32_t round, std::size_t size, std::uint32_t ticks = 60) {
  return {round, "", ticks, false, std::vector<std::uint8_t>(size)};
}

/// Keeps the pieces that are written. While it is locked, it does not answer, as a stuck disk.
class Disk {
 public:
  RecordingWriter::Write write() {
    return
        [state = state_](const RecordingPiece& piece, RecordingWriter::Time now, std::vector<RecordingEvent>& events) {
          const std::lock_guard answers(state->answers);
          const std::lock_guard lock(state->mutex);
          state->pieces.push_back({piece.round, piece.ticks});
          state->threads.push_back(std::this_thread::get_id());
          EXPECT_EQ(now, kTime);
          events.push_back({RecordingEvent::Kind::kFinished, "file", piece.ticks, piece.bytes.size(), ""});
        };
  }
  std::unique_lock<std::mutex> hang() { return std::unique_lock(state_->answers); }

  std::vector<std::pair<std::uint32_t, std::uint32_t>> pieces() const {
    const std::lock_guard lock(state_->mutex);
    return state_->pieces;
  }
  std::vector<std::thread::id> threads() const {
    const std::lock_guard lock(state_->mutex);
    return state_->threads;
  }

 private:
  struct State {
    std::mutex answers;
    std::mutex mutex;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pieces;
    std::vector<std::thread::id> threads;
  };
  std::shared_ptr<State> state_ = std::make_shared<State>();
};

TEST(RecordingWriter, WritesAllPiecesInOrderFromAnotherThread) {
  Disk disk;
  RecordingWriter writer(disk.write());
  std::vector<std::pair<std::uint32_t, std::uint32_t>> expected;
  for (std::uint32_t i = 0; i < 50; ++i) {
    writer.write(piece(1 + i / 10, 100, i), kTime);
    expected.emplace_back(1 + i / 10, i);
  }
  ASSERT_TRUE(writer.finish());
  EXPECT_EQ(disk.pieces(), expected);
  for (const std::thread::id id : disk.threads()) EXPECT_NE(id, std::this_thread::get_id());
  EXPECT_EQ(writer.takeEvents().size(), 50u);
  EXPECT_TRUE(writer.takeEvents().empty());
}

TEST(RecordingWriter, AStuckDiskDoesNotDelayTheCaller) {
  Disk disk;
  RecordingWriter writer(disk.write());
  auto hanging = disk.hang();
  for (std::uint32_t i = 0; i < 100; ++i) writer.write(piece(1, 1000, i), kTime);  // returns
  EXPECT_FALSE(writer.finish(1ms));
  hanging.unlock();
  EXPECT_TRUE(writer.finish());
  EXPECT_EQ(disk.pieces().size(), 100u);
}

TEST(RecordingWriter, ARoundThatDoesNotFitTheQueueIsDroppedAndTheNextTried) {
  Disk disk;
  RecordingWriter writer(disk.write());
  auto hanging = disk.hang();
  constexpr std::size_t kHalf = RecordingWriter::kQueueBytes / 2;
  writer.write(piece(1, kHalf, 1), kTime);
  writer.write(piece(1, kHalf, 2), kTime);
  EXPECT_TRUE(writer.takeEvents().empty());
  writer.write(piece(1, 1, 3), kTime);
  writer.write(piece(1, 1, 4), kTime);
  const std::vector<RecordingEvent> events = writer.takeEvents();
  ASSERT_EQ(events.size(), 1u) << "it is said once";
  EXPECT_EQ(events[0].kind, RecordingEvent::Kind::kStopped);
  EXPECT_EQ(events[0].reason, "the disk is too slow");
  hanging.unlock();
  ASSERT_TRUE(writer.finish());
  writer.write(piece(1, 1, 5), kTime);
  writer.write(piece(2, 1, 6), kTime);
  ASSERT_TRUE(writer.finish());
  EXPECT_EQ(disk.pieces(), (std::vector<std::pair<std::uint32_t, std::uint32_t>>{{1, 1}, {1, 2}, {2, 6}}));
}

TEST(RecordingWriter, GoesWithoutWaitingForAStuckDisk) {
  Disk disk;
  auto hanging = disk.hang();
  std::promise<void> gone;
  std::thread other([&] {
    {
      RecordingWriter writer(disk.write());
      writer.write(piece(1, 1), kTime);
      EXPECT_FALSE(writer.finish(50ms));
    }
    gone.set_value();
  });
  EXPECT_EQ(gone.get_future().wait_for(60s), std::future_status::ready);
  other.join();
  hanging.unlock();
  EXPECT_TRUE(waitUntil([&disk] { return disk.pieces().size() == 1; })) << "the thread outlives the writer";
}

}  // namespace
}  // namespace platon::recording_writer_test
