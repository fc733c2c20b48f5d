#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <memory>
#include <stdexcept>
#include <string>

#include "server/program/async_line_writer.h"
#include "tests/net/support/enet_client.h"
#include "tests/support/files.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_levels.h"
#include "tests/support/wait_until.h"

namespace platon::unread_log_test {
namespace {

/// platon-server with a named pipe as standard error. The test decides whether it is read.
class UnreadLogTest : public testing::Test {
 protected:
  // The level is listed so often that 100 errors of each file are more lines than the queue of the log holds.
  static constexpr std::size_t kFiles = AsyncLineWriter::kQueueLines / 100 + 20;

  UnreadLogTest() {
    writeText(level_, farGoalText());
    if (mkfifo(pipe_.c_str(), 0600) != 0) throw std::runtime_error("cannot make a named pipe");
    std::vector<std::string> command{"sh", "-c", "exec 2>\"$0\" \"$@\"", pipe_};
    std::vector<std::string> arguments(kFiles, level_);
    arguments.insert(arguments.end(), {"--port", "0", "--bind", "127.0.0.1"});
    for (const std::string& word : platonCommand("platon-server", arguments)) command.push_back(word);
    server_ = std::make_unique<Process>(command);
    reader_ = open(pipe_.c_str(), O_RDONLY);
    const std::string line = nextLine();
    const auto port = static_cast<std::uint16_t>(std::stoi(line.substr(line.rfind(':') + 1)));
    client_ = std::make_unique<EnetClient>(port, FakeClient("Ann", 8, [](std::uint32_t) { return 0; }));
  }
  ~UnreadLogTest() override { closeReader(); }

  // The next line of the log without its line feed; empty at the end of the log.
  std::string nextLine() const {
    std::string line;
    for (char byte = 0; read(reader_, &byte, 1) == 1 && byte != '\n';) line += byte;
    return line;
  }

  void closeReader() {
    if (reader_ >= 0) close(reader_);
    reader_ = -1;
  }

  // Writes to the pipe until it is full.
  void fillPipe() const {
    const int writer = open(pipe_.c_str(), O_WRONLY | O_NONBLOCK);
    const std::string block(4096, '.');
    while (write(writer, block.data(), block.size()) > 0) continue;
    close(writer);
  }

  void expectPlays(std::uint32_t ticks) {
    const std::uint32_t end = client_->fake().confirmed() + ticks;
    EXPECT_TRUE(stepUntil([this] { client_->step(); }, [&] { return client_->fake().confirmed() >= end; }));
  }

  void expectStops() {
    server_->signal(SIGTERM);
    EXPECT_EQ(server_->wait(), 0);
  }

  const TemporaryFolder folder_;
  const std::string level_ = folder_ / "test.level";
  const std::string pipe_ = folder_ / "log";
  std::unique_ptr<Process> server_;
  int reader_ = -1;
  std::unique_ptr<EnetClient> client_;
};

TEST_F(UnreadLogTest, AServerWhoseLogReaderIsGoneKeepsTicking) {
  closeReader();
  expectPlays(30);  // "joined" has no reader
  expectStops();
}

TEST_F(UnreadLogTest, AServerWhoseLogPipeIsFullKeepsTickingAndStops) {
  fillPipe();
  expectPlays(30);
  expectStops();
}

TEST_F(UnreadLogTest, AServerReportsTheLinesThatItDropped) {
  fillPipe();
  std::string level = "HEXAHEDRON\n0 -100 -150 0\n3 120 80\n480\n%\n";
  for (int line = 0; line < 100; ++line) level += "x\n";  // an error each
  writeText(level_, level);
  server_->signal(SIGHUP);
  expectPlays(30);
  const std::string report = "log lines dropped lines=";
  std::string line = nextLine();
  while (!line.empty() && !line.starts_with(report)) line = nextLine();
  ASSERT_TRUE(line.starts_with(report)) << line;
  EXPECT_GT(std::stoi(line.substr(report.size())), 0);
  expectStops();
}

}  // namespace
}  // namespace platon::unread_log_test
