#include "protocol/transport/handshake.h"

#include <gtest/gtest.h>

#include <random>

#include "protocol/limits.h"

namespace platon::handshake_test {
namespace {

constexpr auto kVersion = static_cast<std::uint16_t>(kProtocolVersion);

template <std::size_t kSize>
std::array<std::uint8_t, kSize> counting(int first) {
  std::array<std::uint8_t, kSize> bytes;
  for (std::size_t i = 0; i < kSize; ++i) bytes[i] = static_cast<std::uint8_t>(first + static_cast<int>(i));
  return bytes;
}

const CookieReply kReply{counting<16>(1), true, counting<32>(40), counting<17>(100)};
const Open kOpen{counting<17>(100), counting<48>(1)};
const Accept kAccept{counting<16>(1), counting<50>(60)};
const Refusal kRefusal{kVersion, counting<16>(1), RefusalReason::kBanned, "for a day"};
const Info kInfo{kVersion, 0x0123456789abcdef, counting<32>(3), true, 5, 16, "Platon", "0.1.0"};

TEST(Handshake, EveryMessageIsReadBack) {
  const auto knock = decodeKnock(encode(Knock{kVersion, counting<32>(9)}));
  ASSERT_TRUE(knock);
  EXPECT_EQ(knock->version, kVersion);
  EXPECT_EQ(knock->clientKey, counting<32>(9));
  const auto reply = decodeCookieReply(encode(kReply));
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->echo, kReply.echo);
  EXPECT_TRUE(reply->needsPassword);
  EXPECT_EQ(reply->identity, kReply.identity);
  EXPECT_EQ(reply->cookie, kReply.cookie);
  const auto open = decodeOpen(encode(kOpen));
  ASSERT_TRUE(open);
  EXPECT_EQ(open->cookie, kOpen.cookie);
  EXPECT_EQ(open->exchange, kOpen.exchange);
  EXPECT_EQ(open->clientKey(), counting<32>(1));
  const auto accept = decodeAccept(encode(kAccept));
  ASSERT_TRUE(accept);
  EXPECT_EQ(accept->echo, kAccept.echo);
  EXPECT_EQ(accept->exchange, kAccept.exchange);
  const auto refusal = decodeRefusal(encode(kRefusal));
  ASSERT_TRUE(refusal);
  EXPECT_EQ(refusal->reason, RefusalReason::kBanned);
  EXPECT_EQ(refusal->text, "for a day");
  EXPECT_EQ(decodeQuery(encode(Query{77}))->nonce, 77u);
  EXPECT_EQ(decodeInfo(encode(kInfo)), kInfo);
}

// Whoever forges a sender's address must not be able to send more through the server than by himself.
TEST(Handshake, NoAnswerIsLongerThanItsRequest) {
  Refusal longest = kRefusal;
  longest.text = std::string(kMaxReasonBytes, 'x');
  Info fullest = kInfo;
  fullest.name = fullest.program = std::string(kMaxNameBytes, 'x');
  EXPECT_LE(encode(kReply).size(), encode(Knock{}).size());
  EXPECT_LE(encode(Refusal{kVersion, {}, RefusalReason::kWrongVersion, ""}).size(), encode(Knock{}).size());
  EXPECT_LE(encode(kAccept).size(), encode(kOpen).size());
  EXPECT_LE(encode(longest).size(), encode(kOpen).size());
  EXPECT_LE(encode(fullest).size(), encode(Query{}).size());
}

TEST(Handshake, TheVersionOfAKnockCanAlwaysBeRead) {
  Bytes knock = encode(Knock{999, counting<32>(9)});
  std::fill(knock.begin() + 39, knock.end(), std::uint8_t{0xee});  // what a later version may use
  EXPECT_EQ(decodeKnock(knock)->version, 999);
  EXPECT_EQ(decodeRefusal(encode(Refusal{999, {}, RefusalReason::kWrongVersion, ""}))->version, 999);
}

TEST(Handshake, MessagesOfAnotherVersionAreRefused) {
  for (Bytes bytes : {encode(kReply), encode(kOpen), encode(kAccept)}) {
    bytes[5] ^= 1;
    EXPECT_FALSE(decodeCookieReply(bytes) || decodeOpen(bytes) || decodeAccept(bytes));
  }
}

TEST(Handshake, TruncatedAndPaddedMessagesAreRefused) {
  const auto decodes = [](ByteSpan bytes) {
    return decodeKnock(bytes) || decodeCookieReply(bytes) || decodeOpen(bytes) || decodeAccept(bytes) ||
           decodeRefusal(bytes) || decodeQuery(bytes) || decodeInfo(bytes);
  };
  for (const Bytes& whole : {encode(Knock{kVersion, {}}), encode(kReply), encode(kOpen), encode(kAccept),
                             encode(kRefusal), encode(Query{1}), encode(kInfo)}) {
    EXPECT_TRUE(decodes(whole));
    for (std::size_t size = 0; size < whole.size(); ++size) EXPECT_FALSE(decodes(ByteSpan(whole).first(size)));
    Bytes longer = whole;
    longer.push_back(1);
    EXPECT_FALSE(decodes(longer));
  }
}

TEST(Handshake, TextsMustBeLabels) {
  Refusal refusal = kRefusal;
  refusal.text = "a\nb";
  EXPECT_FALSE(decodeRefusal(encode(refusal)));
  Info info = kInfo;
  info.name = "\x1b[2J";
  EXPECT_FALSE(decodeInfo(encode(info)));
}

TEST(Handshake, ReadsRandomBytes) {
  constexpr std::uint64_t seed = 11;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937_64 random(seed);
  const Bytes samples[] = {encode(kReply), encode(kAccept), encode(kRefusal), encode(kInfo)};
  int read = 0;
  for (int round = 0; round < 100000; ++round) {
    Bytes bytes = samples[static_cast<std::size_t>(round) % 4];
    bytes[random() % bytes.size()] = static_cast<std::uint8_t>(random());
    bytes.resize(random() % 4 == 0 ? random() % bytes.size() : bytes.size());
    const bool any = decodeCookieReply(bytes) || decodeAccept(bytes) || decodeRefusal(bytes) || decodeInfo(bytes);
    read += any ? 1 : 0;
  }
  EXPECT_GT(read, 0);
}

}  // namespace
}  // namespace platon::handshake_test
