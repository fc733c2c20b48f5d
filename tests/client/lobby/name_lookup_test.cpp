#include "client/lobby/name_lookup.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <memory>
#include <new>

#include "tests/support/transport/datagram_network.h"
#include "tests/support/wait_until.h"

namespace platon::name_lookup_test {
namespace {

using Answers = std::vector<std::pair<std::string, std::optional<IpAddress>>>;

const IpAddress kAddress = addressAt("198.51.100.1", 1).ip;

std::optional<IpAddress> onlyKnown(const std::string& host) {
  return host == "known.example" ? std::optional(kAddress) : std::nullopt;
}

Answers take(NameLookup& lookup) {
  Answers answers;
  for (const NameLookup::Answer& answer : lookup.take()) answers.emplace_back(answer.host, answer.address);
  return answers;
}

TEST(NameLookupTest, HandsOverEachAnswerOnce) {
  NameLookup lookup({"a.example", "known.example"}, onlyKnown);
  Answers answers;
  EXPECT_TRUE(waitUntil([&] {
    for (auto& answer : take(lookup)) answers.push_back(std::move(answer));
    return !lookup.isPending();
  }));
  EXPECT_EQ(answers, (Answers{{"a.example", std::nullopt}, {"known.example", kAddress}}));
  EXPECT_EQ(take(lookup), Answers{});
}

TEST(NameLookupTest, ANameWhoseLookupThrowsHasNoAddress) {
  NameLookup lookup({"a.example", "b.example", "known.example"}, [](const std::string& host) {
    if (host == "a.example") throw std::bad_alloc();
    if (host == "b.example") throw 1;
    return onlyKnown(host);
  });
  Answers answers;
  EXPECT_TRUE(waitUntil([&] {
    for (auto& answer : take(lookup)) answers.push_back(std::move(answer));
    return !lookup.isPending();
  }));
  EXPECT_EQ(answers, (Answers{{"a.example", std::nullopt}, {"b.example", std::nullopt}, {"known.example", kAddress}}));
}

TEST(NameLookupTest, WithoutNamesNothingIsPending) { EXPECT_FALSE(NameLookup({}, onlyKnown).isPending()); }

TEST(NameLookupTest, TheEndDoesNotWaitForANameAndLooksNoOtherUp) {
  std::promise<void> open;
  const auto asked = std::make_shared<std::atomic<int>>(0);
  std::optional<NameLookup> lookup;
  lookup.emplace(std::vector<std::string>{"slow.example", "next.example"},
                 [gate = open.get_future().share(), asked](const std::string&) -> std::optional<IpAddress> {
                   ++*asked;
                   gate.wait();
                   return std::nullopt;
                 });
  EXPECT_TRUE(waitUntil([&] { return *asked == 1; }));
  EXPECT_EQ(take(*lookup), Answers{});
  lookup.reset();  // would not return if it waited for the name
  open.set_value();
  EXPECT_TRUE(waitUntil([&] { return asked.use_count() == 1; })) << "the thread has ended";
  EXPECT_EQ(*asked, 1);
}

TEST(NameLookupTest, AsksTheSystem) {
  EXPECT_EQ(NameLookup::firstAddressOf("127.0.0.1"), IpAddress::ofIpv4({127, 0, 0, 1}));
  EXPECT_EQ(NameLookup::firstAddressOf("no-such-host.invalid"), std::nullopt);
}

}  // namespace
}  // namespace platon::name_lookup_test
