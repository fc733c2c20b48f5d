#include "protocol/envelope.h"

#include <gtest/gtest.h>

#include "protocol/bytes.h"

#include "to_server_generated.h"

namespace platon::envelope_test {
namespace {

Bytes leave() {
  flatbuffers::FlatBufferBuilder builder;
  const auto body = wire::CreateLeave(builder);
  builder.Finish(wire::CreateToServer(builder, wire::ToServerBody::Leave, body.Union()));
  return bytesOf(builder);
}

const wire::ToServer* rootOf(const Envelope<wire::ToServer>& envelope) { return envelope.root(); }

TEST(Envelope, GivesTheRootOfAVerifiedBuffer) {
  const Envelope<wire::ToServer> envelope(leave());
  ASSERT_NE(rootOf(envelope), nullptr);
  EXPECT_EQ(rootOf(envelope)->body_type(), wire::ToServerBody::Leave);
}

TEST(Envelope, ReadsBytesAtAnyAddress) {
  Bytes shifted = leave();
  for (std::size_t offset = 1; offset < 8; ++offset) {
    shifted.insert(shifted.begin(), 0);
    EXPECT_NE(rootOf(Envelope<wire::ToServer>(std::span(shifted).subspan(offset))), nullptr) << offset;
  }
}

TEST(Envelope, HasNoRootForEmptyOversizedOrMalformedBytes) {
  EXPECT_EQ(rootOf(Envelope<wire::ToServer>(Bytes{})), nullptr);
  Bytes longest = leave();
  longest.resize(kMaxMessageBytes);
  EXPECT_NE(rootOf(Envelope<wire::ToServer>(longest)), nullptr);
  longest.push_back(0);
  EXPECT_EQ(rootOf(Envelope<wire::ToServer>(longest)), nullptr);
  Bytes malformed = leave();
  malformed[0] = 0xff;  // the offset of the root points beyond the end
  EXPECT_EQ(rootOf(Envelope<wire::ToServer>(malformed)), nullptr);
}

TEST(Envelope, MissingFieldsReadAsEmpty) {
  EXPECT_TRUE(spanOf(nullptr).empty());
  EXPECT_EQ(textOf(nullptr), "");
}

}  // namespace
}  // namespace platon::envelope_test
