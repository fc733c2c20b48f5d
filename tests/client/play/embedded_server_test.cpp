#include "client/play/embedded_server.h"

#include <chrono>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "client/session/network_client.h"
#include "client/time/steady_now.h"
#include "protocol/program_error.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon {
namespace {

constexpr const char* kLevel = "levels/hexahedron/01_first_steps.level";

bool connects(const ServerAddress& address) {
  const Clock clock = steadyClock();
  NetworkClient client(address, {"someone"}, clock.now());
  const Moment end = clock.now() + std::chrono::seconds(10);
  for (Moment now = clock.now(); now < end && !client.welcomed() && !client.ending(); now = clock.now()) {
    client.update(now, [](const Game&, std::uint32_t) { return Input{}; });
    clock.sleepUntil(now + std::chrono::milliseconds(2));
  }
  return client.welcomed();
}

// The exit code and the message of the error.
std::pair<int, std::string> errorOf(const std::string& levelFile) {
  try {
    const EmbeddedServer server(levelFile);
    return {0, ""};
  } catch (const ProgramError& error) {
    return {error.exitCode(), error.what()};
  }
}

TEST(EmbeddedServer, AcceptsAClientOnLoopback) {
  const EmbeddedServer server(kLevel);
  EXPECT_EQ(server.address().host, "127.0.0.1");
  EXPECT_NE(server.address().port, 0);
  EXPECT_TRUE(connects(server.address()));
}

TEST(EmbeddedServer, WithoutALevelFileItPlaysTheShippedLevels) {
  const EmbeddedServer server("");
  EXPECT_TRUE(connects(server.address()));
}

TEST(EmbeddedServer, EachServerHasAPortOfItsOwn) {
  const EmbeddedServer first(kLevel);
  const EmbeddedServer second(kLevel);
  EXPECT_NE(first.address().port, second.address().port);
}

TEST(EmbeddedServer, AMissingLevelFileIsAUsageError) {
  const auto [exitCode, message] = errorOf("levels/no_such.level");
  EXPECT_EQ(exitCode, ProgramError::kUsage);
  EXPECT_NE(message.find("levels/no_such.level"), std::string::npos) << message;
}

TEST(EmbeddedServer, AnInvalidLevelIsALevelError) {
  const TemporaryFolder folder;
  const std::string file = folder / "invalid.level";
  writeText(file, "CUBE\n");
  const auto [exitCode, message] = errorOf(file);
  EXPECT_EQ(exitCode, ProgramError::kLevel);
  EXPECT_EQ(message.find(file + ":1:1: error: "), 0U) << message;
}

}  // namespace
}  // namespace platon
