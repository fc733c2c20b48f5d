#include "server/program/async_line_writer.h"

#include <fcntl.h>
#include <unistd.h>

#include <chrono>
#include <optional>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

namespace platon::async_line_writer_test {
namespace {

void log(DescriptorSink& sink, const std::string& text) {
  sink.log(spdlog::details::log_msg("log", spdlog::level::info, text));
}

struct Pipe {
  Pipe() {
    int ends[2] = {-1, -1};
    EXPECT_EQ(pipe(ends), 0);
    reader = ends[0];
    writer = ends[1];
  }
  ~Pipe() {
    close(reader);
    close(writer);
  }

  int reader = -1;
  int writer = -1;
};

TEST(DescriptorSink, WritesEachMessageAsALine) {
  const Pipe pipe;
  DescriptorSink sink(pipe.writer);
  log(sink, "one");
  log(sink, "two");
  char buffer[100];
  const ssize_t size = read(pipe.reader, buffer, sizeof buffer);
  ASSERT_GT(size, 0);
  EXPECT_EQ(std::string(buffer, static_cast<std::size_t>(size)), "one\ntwo\n");
}

TEST(DescriptorSink, IsFlushedAfterTheFirstFlush) {
  const Pipe pipe;
  DescriptorSink sink(pipe.writer);
  const std::future<void> flushed = sink.flushed();
  EXPECT_EQ(flushed.wait_for(std::chrono::seconds(0)), std::future_status::timeout);
  sink.flush();
  sink.flush();
  EXPECT_EQ(flushed.wait_for(std::chrono::seconds(0)), std::future_status::ready);
}

TEST(DescriptorSink, WritesNothingAfterDiscard) {
  const Pipe pipe;
  DescriptorSink sink(pipe.writer);
  sink.discard();
  log(sink, "late");
  fcntl(pipe.reader, F_SETFL, O_NONBLOCK);
  char byte = 0;
  EXPECT_EQ(read(pipe.reader, &byte, 1), -1);
}

TEST(DescriptorSink, ALineForAClosedDescriptorIsDropped) {
  int closed = -1;
  {
    const Pipe pipe;
    closed = pipe.writer;
  }
  DescriptorSink sink(closed);
  log(sink, "nowhere");
}

/// A pipe into which an AsyncLineWriter writes.
class AsyncLineWriterTest : public testing::Test {
 protected:
  AsyncLineWriterTest() {
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("cannot make a pipe");
    reader_ = ends[0];
    descriptor_ = ends[1];
    writer_.emplace(descriptor_);
  }
  ~AsyncLineWriterTest() override {
    close(descriptor_);
    close(reader_);
  }

  // Waits until the pipe has something to read.
  std::string readSome() const {
    char buffer[4096];
    const ssize_t size = read(reader_, buffer, sizeof buffer);
    if (size <= 0) throw std::runtime_error("nothing more can be read");
    return {buffer, static_cast<std::size_t>(size)};
  }

  // Reads the pipe to its end. Call it after the writer has been destroyed.
  std::string readAll() {
    close(descriptor_);
    std::string text;
    char buffer[4096];
    for (ssize_t size; (size = read(reader_, buffer, sizeof buffer)) > 0;) {
      text.append(buffer, static_cast<std::size_t>(size));
    }
    return text;
  }

  // Writes to the pipe until it is full. The pipe is non-blocking only until this function ends.
  void fillPipe() const {
    const int flags = fcntl(descriptor_, F_GETFL);
    fcntl(descriptor_, F_SETFL, flags | O_NONBLOCK);
    const std::string block(4096, '.');
    while (::write(descriptor_, block.data(), block.size()) > 0) continue;
    fcntl(descriptor_, F_SETFL, flags);
  }

  int reader_ = -1;
  int descriptor_ = -1;
  std::optional<AsyncLineWriter> writer_;
};

TEST_F(AsyncLineWriterTest, WritesLinesInOrder) {
  writer_->write("one");
  writer_->write("");
  writer_->write("two {} %v");
  writer_.reset();
  EXPECT_EQ(readAll(), "one\n\ntwo {} %v\n");
}

TEST_F(AsyncLineWriterTest, TheDestructorWritesTheWholeQueue) {
  std::string expected;
  for (int i = 0; i < 1000; ++i) {
    writer_->write(std::to_string(i));
    expected += std::to_string(i) + "\n";
  }
  writer_.reset();
  EXPECT_EQ(readAll(), expected);
}

TEST_F(AsyncLineWriterTest, ALineLongerThanThePipeBufferIsWrittenWhole) {
  const std::string line(20000, 'x');
  writer_->write(line);
  writer_.reset();
  EXPECT_EQ(readAll(), line + "\n");
}

// Without a reader a write raises SIGPIPE, which would end this test.
TEST_F(AsyncLineWriterTest, ALogWhoseReaderIsGoneDropsItsLines) {
  close(reader_);
  reader_ = -1;
  for (int i = 0; i < 10; ++i) writer_->write("nobody reads this");
  writer_.reset();
}

TEST_F(AsyncLineWriterTest, AFullPipeBlocksNeitherWriteNorDestructor) {
  fillPipe();
  for (std::size_t i = 0; i < 3 * AsyncLineWriter::kQueueLines; ++i) writer_->write("nobody reads this");
  writer_.reset();
}

TEST_F(AsyncLineWriterTest, LinesDroppedFromTheFullQueueAreCountedOnceTheReaderReadsAgain) {
  fillPipe();
  constexpr std::size_t kLines = AsyncLineWriter::kQueueLines + 500;
  for (std::size_t i = 0; i < kLines; ++i) writer_->write("line " + std::to_string(i));
  EXPECT_EQ(writer_->takeDropped(), 0u);  // the queue is full
  std::uint64_t dropped = 0;
  std::string text;
  while (dropped == 0) {
    text += readSome();
    dropped = writer_->takeDropped();
  }
  // One line may have left the queue and wait for the pipe.
  EXPECT_GE(dropped, 499u);
  EXPECT_LE(dropped, 500u);
  EXPECT_EQ(writer_->takeDropped(), 0u);  // each is counted once
  // The oldest were dropped. All others are read before the destructor waits for a pipe that may be full.
  while (!text.ends_with("line " + std::to_string(kLines - 1) + "\n")) text += readSome();
  writer_.reset();
}

}  // namespace
}  // namespace platon::async_line_writer_test
