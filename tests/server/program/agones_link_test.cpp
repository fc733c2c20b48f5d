#include "server/program/agones_link.h"

#include <gtest/gtest.h>

#include "tests/server/fleet/fake_sidecar.h"
#include "tests/support/test_levels.h"
#include "tests/support/wait_until.h"

namespace platon::agones_link_test {
namespace {

class AgonesLinkTest : public testing::Test {
 protected:
  AgonesLink linkTo(std::optional<std::uint16_t> port) {
    return {port, [] { return std::chrono::steady_clock::now(); }};
  }

  // Steps until the sidecar has taken a call that begins with this.
  bool reaches(AgonesLink& link, const std::string& call, std::size_t calls = 1) {
    return stepUntil([&] { link.report(match_, log_); }, [&] { return sidecar_.count(call) >= calls; });
  }

  FakeSidecar sidecar_;
  std::vector<std::string> lines_;
  Log log_{LogFormat::kText, [this](std::string_view line) { lines_.emplace_back(line); }};
  Match match_{LevelRotation({levelOf(farGoalText())}), {16, "Test"}};
};

TEST_F(AgonesLinkTest, WithoutASidecarNothingHappens) {
  AgonesLink link = linkTo({});
  link.start(log_);
  link.report(match_, log_);
  link.finish(log_);
  EXPECT_EQ(lines_, std::vector<std::string>{});
  EXPECT_EQ(sidecar_.requests(), 0u);
}

TEST_F(AgonesLinkTest, AMatchThatDrainsIsFull) {
  AgonesLink link = linkTo(sidecar_.port());
  link.start(log_);
  match_.receive(1, Hello{});
  ASSERT_TRUE(reaches(link, "PATCH /v1beta1/counters/players {\"count\":\"1\",\"capacity\":\"16\"}"));
  match_.drain("", {});
  ASSERT_TRUE(reaches(link, "PATCH /v1beta1/counters/players {\"count\":\"16\",\"capacity\":\"16\"}"));
  link.finish(log_);
  EXPECT_EQ(sidecar_.calls().back(), "POST /shutdown {}");
  EXPECT_EQ(lines_, std::vector<std::string>{"agones at port " + std::to_string(sidecar_.port())});
}

TEST_F(AgonesLinkTest, ASidecarThatWasNotToldTheEndIsLogged) {
  AgonesLink link = linkTo(sidecar_.port());
  sidecar_.vanish();
  link.start(log_);
  link.finish(log_);
  EXPECT_EQ(lines_.back(), "agones was not told that the server stops");
}

}  // namespace
}  // namespace platon::agones_link_test
