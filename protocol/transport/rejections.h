#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace platon {

/// How often something was rejected for one reason.
struct Rejection {
  std::string_view reason;  ///< one word, for logs and metrics
  std::uint64_t count = 0;

  friend bool operator==(const Rejection&, const Rejection&) = default;
};

/// All that a server has rejected so far, by reason. Each part of it that rejects something counts it here.
struct Rejections {
  std::uint64_t malformed = 0;    ///< datagrams of no known form
  std::uint64_t version = 0;      ///< knocks of another protocol version, which were told so
  std::uint64_t cookie = 0;       ///< Open with an invalid cookie, or one that was used before
  std::uint64_t handshakes = 0;   ///< Open beyond the budget of its address or of the server
  std::uint64_t password = 0;     ///< Open with a wrong password
  std::uint64_t full = 0;         ///< Open when no session was free; Open from, or answers to a challenge at, an
                                  ///< address whose household or site has no room
  std::uint64_t banned = 0;       ///< Open from, or answers to a challenge at, a banned address; clients whose address
                                  ///< was banned after they had connected
  std::uint64_t queries = 0;      ///< beyond the budget
  std::uint64_t seal = 0;         ///< sealed datagrams that are forged, damaged, repeated, or of no session
  std::uint64_t unconfirmed = 0;  ///< sessions that were not confirmed in time
  std::uint64_t content = 0;      ///< sealed datagrams with something that no client of ours sends
  std::uint64_t excess = 0;       ///< datagrams beyond the budget of their connection
  std::uint64_t idle = 0;         ///< connections that were not admitted in time
  std::uint64_t silent = 0;       ///< admitted connections from which nothing came
  std::uint64_t slow = 0;         ///< connections that did not acknowledge what was sent
  std::uint64_t message = 0;      ///< messages that were malformed

  /// One for each of these, always in this order.
  std::vector<Rejection> list() const {
    return {{"malformed", malformed}, {"version", version},
            {"cookie", cookie},       {"handshakes", handshakes},
            {"password", password},   {"full", full},
            {"banned", banned},       {"queries", queries},
            {"seal", seal},           {"unconfirmed", unconfirmed},
            {"content", content},     {"excess", excess},
            {"idle", idle},           {"silent", silent},
            {"slow", slow},           {"message", message}};
  }

  friend bool operator==(const Rejections&, const Rejections&) = default;
};

}  // namespace platon
