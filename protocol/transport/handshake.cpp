#include "protocol/transport/handshake.h"

#include <algorithm>
#include <cassert>
#include <string_view>

#include "protocol/label.h"
#include "protocol/limits.h"

namespace platon {
namespace {

constexpr std::string_view kMagic = "PLTN";
constexpr std::size_t kHeadBytes = 1 + kMagic.size() + 2;

/// Writes the fields of one datagram.
class Writer {
 public:
  Writer(HandshakeKind kind, std::uint16_t version) {
    bytes_.reserve(kQueryBytes);
    number(static_cast<std::uint8_t>(kind));
    for (const char letter : kMagic) number(static_cast<std::uint8_t>(letter));
    number(version);
  }

  /// Least significant byte first.
  template <class Number>
  void number(Number value) {
    for (std::size_t i = 0; i < sizeof(Number); ++i) bytes_.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
  }
  void raw(ByteSpan bytes) { bytes_.insert(bytes_.end(), bytes.begin(), bytes.end()); }
  void text(const std::string& text) {
    number(static_cast<std::uint8_t>(text.size()));
    bytes_.insert(bytes_.end(), text.begin(), text.end());
  }

  Bytes take(std::size_t paddedBytes = 0) {
    bytes_.resize(std::max(bytes_.size(), paddedBytes));
    return std::move(bytes_);
  }

 private:
  Bytes bytes_;
};

/// Reads the fields of one datagram after its head. Reading past the end makes `ok` false.
class Reader {
 public:
  Reader(HandshakeKind kind, ByteSpan datagram) {
    const std::optional<HandshakeHead> head = readHead(datagram);
    ok_ = head && head->kind == kind;
    if (!ok_) return;
    version_ = head->version;
    remaining_ = datagram.subspan(kHeadBytes);
  }

  template <class Number>
  Number number() {
    Number value = 0;
    const ByteSpan bytes = take(sizeof(Number));
    for (std::size_t i = 0; i < bytes.size(); ++i)
      value = static_cast<Number>(value | static_cast<Number>(bytes[i]) << (8 * i));
    return value;
  }
  template <std::size_t kSize>
  void raw(std::array<std::uint8_t, kSize>& bytes) {
    const ByteSpan source = take(kSize);
    std::copy(source.begin(), source.end(), bytes.begin());
  }
  std::string label(std::size_t maxBytes) {
    const ByteSpan source = take(number<std::uint8_t>());
    std::string text(source.begin(), source.end());
    ok_ = ok_ && isLabel(text, maxBytes);
    return text;
  }

  std::uint16_t version() const { return version_; }
  bool ok() const { return ok_; }
  /// Whether everything was read and the rest is nothing but padding.
  bool complete() const {
    return ok_ && std::all_of(remaining_.begin(), remaining_.end(), [](std::uint8_t byte) { return byte == 0; });
  }
  bool completeOfThisVersion() const { return complete() && version_ == kProtocolVersion; }

 private:
  ByteSpan take(std::size_t count) {
    ok_ = ok_ && count <= remaining_.size();
    if (!ok_) return {};
    const ByteSpan taken = remaining_.first(count);
    remaining_ = remaining_.subspan(count);
    return taken;
  }

  ByteSpan remaining_;
  std::uint16_t version_ = 0;
  bool ok_ = false;
};

constexpr auto kOurVersion = static_cast<std::uint16_t>(kProtocolVersion);

}  // namespace

CryptoKey Open::clientKey() const {
  CryptoKey key;
  std::copy_n(exchange.begin(), key.size(), key.begin());
  return key;
}

Bytes prologueOf(const CryptoKey& identity) {
  Bytes prologue(kMagic.begin(), kMagic.end());
  prologue.push_back(static_cast<std::uint8_t>(kOurVersion));
  prologue.push_back(static_cast<std::uint8_t>(kOurVersion >> 8));
  prologue.insert(prologue.end(), identity.begin(), identity.end());
  return prologue;
}

Echo echoOf(const CryptoKey& clientKey) {
  Echo echo;
  std::copy_n(clientKey.begin(), echo.size(), echo.begin());
  return echo;
}

std::optional<HandshakeHead> readHead(ByteSpan datagram) {
  if (datagram.size() < kHeadBytes || !std::equal(kMagic.begin(), kMagic.end(), datagram.begin() + 1)) {
    return std::nullopt;
  }
  const std::uint8_t kind = datagram[0];
  if (kind < static_cast<std::uint8_t>(HandshakeKind::kKnock) ||
      kind > static_cast<std::uint8_t>(HandshakeKind::kInfo)) {
    return std::nullopt;
  }
  const auto version = static_cast<std::uint16_t>(datagram[kHeadBytes - 2] | datagram[kHeadBytes - 1] << 8);
  return HandshakeHead{static_cast<HandshakeKind>(kind), version};
}

Bytes encode(const Knock& message) {
  Writer writer(HandshakeKind::kKnock, message.version);
  writer.raw(message.clientKey);
  return writer.take(kKnockBytes);
}

std::optional<Knock> decodeKnock(ByteSpan datagram) {
  if (datagram.size() != kKnockBytes) return std::nullopt;
  Reader reader(HandshakeKind::kKnock, datagram);
  Knock message;
  message.version = reader.version();
  reader.raw(message.clientKey);
  return reader.ok() ? std::optional(message) : std::nullopt;  // later versions may use the padding
}

Bytes encode(const CookieReply& message) {
  Writer writer(HandshakeKind::kCookie, kOurVersion);
  writer.raw(message.echo);
  writer.number(static_cast<std::uint8_t>(message.needsPassword ? 1 : 0));
  writer.raw(message.identity);
  writer.raw(message.cookie);
  return writer.take();
}

std::optional<CookieReply> decodeCookieReply(ByteSpan datagram) {
  Reader reader(HandshakeKind::kCookie, datagram);
  CookieReply message;
  reader.raw(message.echo);
  const auto flags = reader.number<std::uint8_t>();
  message.needsPassword = flags == 1;
  reader.raw(message.identity);
  reader.raw(message.cookie);
  return reader.completeOfThisVersion() && flags <= 1 ? std::optional(message) : std::nullopt;
}

Bytes encode(const Open& message) {
  Writer writer(HandshakeKind::kOpen, kOurVersion);
  writer.raw(message.cookie);
  writer.raw(message.exchange);
  return writer.take(kOpenBytes);
}

std::optional<Open> decodeOpen(ByteSpan datagram) {
  if (datagram.size() != kOpenBytes) return std::nullopt;
  Reader reader(HandshakeKind::kOpen, datagram);
  Open message;
  reader.raw(message.cookie);
  reader.raw(message.exchange);
  return reader.completeOfThisVersion() ? std::optional(message) : std::nullopt;
}

Bytes encode(const Accept& message) {
  Writer writer(HandshakeKind::kAccept, kOurVersion);
  writer.raw(message.echo);
  writer.raw(message.exchange);
  return writer.take();
}

std::optional<Accept> decodeAccept(ByteSpan datagram) {
  Reader reader(HandshakeKind::kAccept, datagram);
  Accept message;
  reader.raw(message.echo);
  reader.raw(message.exchange);
  return reader.completeOfThisVersion() ? std::optional(message) : std::nullopt;
}

Bytes encode(const Refusal& message) {
  assert(message.text.size() <= kMaxReasonBytes);
  Writer writer(HandshakeKind::kRefusal, message.version);
  writer.raw(message.echo);
  writer.number(static_cast<std::uint8_t>(message.reason));
  writer.text(message.text);
  return writer.take();
}

std::optional<Refusal> decodeRefusal(ByteSpan datagram) {
  Reader reader(HandshakeKind::kRefusal, datagram);
  Refusal message;
  message.version = reader.version();
  reader.raw(message.echo);
  message.reason = static_cast<RefusalReason>(reader.number<std::uint8_t>());
  message.text = reader.label(kMaxReasonBytes);
  const bool known = message.reason >= RefusalReason::kWrongVersion && message.reason <= RefusalReason::kPassword;
  return reader.complete() && known ? std::optional(message) : std::nullopt;
}

Bytes encode(const Query& message) {
  Writer writer(HandshakeKind::kQuery, kOurVersion);
  writer.number(message.nonce);
  return writer.take(kQueryBytes);
}

std::optional<Query> decodeQuery(ByteSpan datagram) {
  if (datagram.size() != kQueryBytes) return std::nullopt;
  Reader reader(HandshakeKind::kQuery, datagram);
  const Query message{reader.number<std::uint64_t>()};
  return reader.complete() ? std::optional(message) : std::nullopt;
}

Bytes encode(const Info& message) {
  assert(message.name.size() <= kMaxNameBytes && message.program.size() <= kMaxNameBytes);
  Writer writer(HandshakeKind::kInfo, message.version);
  writer.number(message.nonce);
  writer.raw(message.identity);
  writer.number(static_cast<std::uint8_t>(message.needsPassword ? 1 : 0));
  writer.number(message.players);
  writer.number(message.maxPlayers);
  writer.text(message.name);
  writer.text(message.program);
  return writer.take();
}

std::optional<Info> decodeInfo(ByteSpan datagram) {
  Reader reader(HandshakeKind::kInfo, datagram);
  Info message;
  message.version = reader.version();
  message.nonce = reader.number<std::uint64_t>();
  reader.raw(message.identity);
  const auto flags = reader.number<std::uint8_t>();
  message.needsPassword = flags == 1;
  message.players = reader.number<std::uint16_t>();
  message.maxPlayers = reader.number<std::uint16_t>();
  message.name = reader.label(kMaxNameBytes);
  message.program = reader.label(kMaxNameBytes);
  return reader.complete() && flags <= 1 ? std::optional(message) : std::nullopt;
}

}  // namespace platon
