#include "tests/fuzz/handshake_forms.h"

#include <algorithm>

#include "protocol/transport/handshake.h"

namespace platon::fuzz {
namespace {

constexpr std::size_t kVersionAt = 5;
constexpr std::size_t kHeadBytes = kVersionAt + 2;
constexpr std::size_t kKnockFields = kHeadBytes + sizeof(CryptoKey);

// The bytes of a message that later versions of the protocol may change, made equal.
platon::Bytes comparable(HandshakeKind kind, ByteSpan datagram) {
  platon::Bytes bytes(datagram.begin(), datagram.end());
  if (kind == HandshakeKind::kKnock) std::fill(bytes.begin() + kKnockFields, bytes.end(), std::uint8_t{0});
  if (kind == HandshakeKind::kQuery) std::fill_n(bytes.begin() + kVersionAt, 2, std::uint8_t{0});
  return bytes;
}

/// Checks one decoder after the other.
class Decoders {
 public:
  explicit Decoders(ByteSpan datagram) : datagram_(datagram), head_(readHead(datagram)) {}

  template <class Message>
  void check(HandshakeKind kind, const std::optional<Message>& message) {
    if (!message) return;
    if (!head_ || head_->kind != kind) return fail("a decoder takes a datagram of another kind");
    platon::Bytes again = comparable(kind, encode(*message));
    if (again.size() > datagram_.size()) return fail("a decoder takes a datagram that is too short");
    again.resize(datagram_.size());
    if (again != comparable(kind, datagram_)) fail("a datagram of the handshake differs after decoding and encoding");
  }

  const std::string& fault() const { return fault_; }

 private:
  void fail(const char* what) { fault_ = what; }

  ByteSpan datagram_;
  std::optional<HandshakeHead> head_;
  std::string fault_;
};

}  // namespace

std::string handshakeFormFault(ByteSpan datagram) {
  Decoders decoders(datagram);
  decoders.check(HandshakeKind::kKnock, decodeKnock(datagram));
  decoders.check(HandshakeKind::kCookie, decodeCookieReply(datagram));
  decoders.check(HandshakeKind::kOpen, decodeOpen(datagram));
  decoders.check(HandshakeKind::kAccept, decodeAccept(datagram));
  decoders.check(HandshakeKind::kRefusal, decodeRefusal(datagram));
  decoders.check(HandshakeKind::kQuery, decodeQuery(datagram));
  decoders.check(HandshakeKind::kInfo, decodeInfo(datagram));
  return decoders.fault();
}

}  // namespace platon::fuzz
