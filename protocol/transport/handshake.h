#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "protocol/transport/noise.h"

namespace platon {

/// The datagrams that are not sealed: those before a session, and the query for lists of servers. docs/protocol.md
/// specifies them byte by byte. Every one begins with its kind, "PLTN", and the protocol version of its sender; the
/// layouts of Knock and Refusal are the same in all versions.
enum class HandshakeKind : std::uint8_t {
  kKnock = 1,
  kCookie = 2,
  kOpen = 3,
  kAccept = 4,
  kRefusal = 5,
  kQuery = 6,
  kInfo = 7,
};

/// What a client sends is padded to these sizes, so that no answer is longer than its request.
inline constexpr std::size_t kKnockBytes = 256;
inline constexpr std::size_t kOpenBytes = 256;
inline constexpr std::size_t kQueryBytes = 512;

/// The first bytes of the client's ephemeral key. Answers repeat them, so that only who has seen the request can
/// answer.
using Echo = std::array<std::uint8_t, 16>;

/// Proves that the client receives at its address: the epoch, then a keyed hash.
using Cookie = std::array<std::uint8_t, 17>;

struct HandshakeHead {
  HandshakeKind kind{};
  std::uint16_t version = 0;
};

/// Client: the first datagram. `version` is kProtocolVersion, except that a server reads that of any client.
struct Knock {
  std::uint16_t version = 0;
  CryptoKey clientKey{};  ///< ephemeral
};

/// Server: the answer to Knock.
struct CookieReply {
  Echo echo{};
  bool needsPassword = false;
  CryptoKey identity{};  ///< Ed25519
  Cookie cookie{};
};

/// Client: the first message of the key exchange, and the cookie for its ephemeral key.
struct Open {
  Cookie cookie{};
  std::array<std::uint8_t, NoiseExchange::kOverhead> exchange{};

  CryptoKey clientKey() const;
};

/// Server: the second message of the key exchange. Its payload is the number of the session's slot.
struct Accept {
  Echo echo{};
  std::array<std::uint8_t, NoiseExchange::kOverhead + 2> exchange{};
};

enum class RefusalReason : std::uint8_t {
  kWrongVersion = 1,  ///< the versions differ; the head has the server's
  kFull = 2,          ///< no connection is free
  kAddress = 3,       ///< too many connections from the client's address
  kBanned = 4,
  kPassword = 5,  ///< wrong or missing
};

/// Server: the end of the handshake. `text` is a label of at most kMaxReasonBytes, for the player.
struct Refusal {
  std::uint16_t version = 0;
  Echo echo{};
  RefusalReason reason{};
  std::string text;
};

/// Anybody: asks what Info tells.
struct Query {
  std::uint64_t nonce = 0;
};

/// Server: the answer to Query, for lists of servers. Unauthenticated.
struct Info {
  std::uint16_t version = 0;  ///< of the protocol
  std::uint64_t nonce = 0;    ///< that of the query
  CryptoKey identity{};
  bool needsPassword = false;
  std::uint16_t players = 0;
  std::uint16_t maxPlayers = 0;
  std::string name;     ///< of the server: a label of at most kMaxNameBytes
  std::string program;  ///< version of the program: a label of at most kMaxNameBytes

  friend bool operator==(const Info&, const Info&) = default;
};

/// The prologue of the key exchange: "PLTN", the protocol version, the server's identity.
Bytes prologueOf(const CryptoKey& identity);
Echo echoOf(const CryptoKey& clientKey);

/// The head of any of these datagrams; nothing if it is none.
std::optional<HandshakeHead> readHead(ByteSpan datagram);

Bytes encode(const Knock& message);
Bytes encode(const CookieReply& message);
Bytes encode(const Open& message);
Bytes encode(const Accept& message);
Bytes encode(const Refusal& message);
Bytes encode(const Query& message);
Bytes encode(const Info& message);

/// Each decoder returns nothing if the datagram is not of its kind, has another size, or a value is out of range. Those
/// of Cookie, Open and Accept also refuse another protocol version.
std::optional<Knock> decodeKnock(ByteSpan datagram);
std::optional<CookieReply> decodeCookieReply(ByteSpan datagram);
std::optional<Open> decodeOpen(ByteSpan datagram);
std::optional<Accept> decodeAccept(ByteSpan datagram);
std::optional<Refusal> decodeRefusal(ByteSpan datagram);
std::optional<Query> decodeQuery(ByteSpan datagram);
std::optional<Info> decodeInfo(ByteSpan datagram);

}  // namespace platon
