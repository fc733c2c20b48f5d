#include "server/program/descriptor_sink.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <string>

namespace platon::descriptor_sink_test {
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

}  // namespace
}  // namespace platon::descriptor_sink_test
