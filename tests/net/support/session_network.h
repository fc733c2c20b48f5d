#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "client/session/session.h"
#include "tests/net/support/virtual_network.h"

namespace platon {

/// A match and the sessions of its clients in a virtual network. Checks after each update of a client that its
/// confirmed game equals the server's, except after the last tick of a round.
class SessionNetwork : public VirtualNetwork {
 public:
  using Tampering = std::function<void(std::vector<std::uint8_t>&)>;

  SessionNetwork(std::vector<std::shared_ptr<const Level>> levels, std::uint64_t seed, std::uint32_t maxPlayers = 16,
                 MatchProgram program = {});

  /// A client with these controls joins now; `observer`, if any, follows its confirmed game. Returns its index.
  std::size_t join(const LinkQuality& quality, Controls controls,
                   std::shared_ptr<ConfirmedObserver> observer = nullptr);
  /// The client's connection is lost, with all messages in flight. The server detects it after `detectedAfter`;
  /// nothing: never.
  void disconnect(std::size_t client, std::optional<Time> detectedAfter);
  /// The client reconnects and continues with the memory of its last session.
  void resume(std::size_t client);
  /// Time between two updates of a client; default 4 ms.
  void setFrame(Time frame) { frame_ = frame; }
  /// From now on, `change` may modify every message that this client receives.
  void tamper(std::size_t client, Tampering change) { clients_[client]->tamper = std::move(change); }
  /// Whether the client's confirmed game is checked. Default: true.
  void setChecked(std::size_t client, bool checked) { clients_[client]->checked = checked; }
  /// Lets time pass.
  void run(Time duration);

  const Session& session(std::size_t client) const { return *clients_[client]->session; }
  Session& session(std::size_t client) { return *clients_[client]->session; }
  std::optional<DesyncReport> takeDesync(std::size_t client) { return session(client).takeDesync(); }
  std::uint32_t slot(std::size_t client) const { return session(client).welcome()->slot; }

 private:
  struct Client : VirtualClient {
    Client(const SessionNetwork& owner, const LinkQuality& connection, Controls buttons)
        : network(owner), quality(connection), controls(std::move(buttons)) {}

    void receive(std::vector<std::uint8_t> bytes, Time now) override;
    void update(Time now) override;
    std::vector<OutgoingMessage> takeOutgoing() override { return session->takeOutgoing(); }
    void expectInLockstep() const;

    const SessionNetwork& network;
    LinkQuality quality;
    Controls controls;
    ClientId id = 0;  // of the current connection
    std::optional<Session> session;
    Time nextUpdate{};
    Tampering tamper = [](std::vector<std::uint8_t>&) {};
    bool checked = true;
  };

  std::vector<std::unique_ptr<Client>> clients_;
  Time frame_ = std::chrono::milliseconds(4);
};

}  // namespace platon
