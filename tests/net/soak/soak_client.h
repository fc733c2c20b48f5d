#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "client/session/dialogue.h"
#include "client/session/session.h"

namespace platon {

/// What a player keeps from one session to the next.
struct SoakMemory {
  SessionToken token{};
  Session::Memory game;  ///< of a client with a game
};

/// A session of either kind.
class SoakClient {
 public:
  virtual ~SoakClient() = default;

  virtual void receive(std::span<const std::uint8_t> bytes, Time now) = 0;
  virtual void update(Time now) = 0;
  virtual void leave() = 0;
  virtual std::vector<OutgoingMessage> takeOutgoing() = 0;

  /// Why the session has ended; empty while it runs.
  virtual std::optional<std::string> ending() const = 0;
  virtual const std::optional<Welcome>& welcome() const = 0;
  /// Ticks of all rounds that the session has confirmed.
  virtual std::uint64_t confirmedTicks() const = 0;
  virtual void remember(SoakMemory& memory) const = 0;
  /// Null for a client without a game.
  virtual const Session* session() const { return nullptr; }
};

/// `seed`: of the buttons. `isRestless`: they change in every tick.
std::unique_ptr<SoakClient> makeHollowClient(const std::string& name, const SoakMemory& memory, std::uint64_t seed,
                                             bool isRestless, Time now);
std::unique_ptr<SoakClient> makePlayingClient(const std::string& name, const SoakMemory& memory, std::uint64_t seed,
                                              Time now);

}  // namespace platon
