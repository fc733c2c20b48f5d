#pragma once

#include <chrono>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "protocol/files/descriptor.h"
#include "tests/server/fleet/sidecar_request.h"

namespace platon {

/// Stands in for the sidecar of Agones, with a game server and its counter of players. Answers the requests that the
/// description of Agones allows (SidecarRequest), and anything else with an error.
class FakeSidecar {
 public:
  enum class Mode {
    kAnswers,
    kIsLate,   ///< does at once what it is told, and answers after kLateness
    kRefuses,  ///< with HTTP status 500
    kIsSilent  ///< keeps connections open without an answer
  };

  /// Longer than the server waits for an answer.
  static constexpr std::chrono::milliseconds kLateness{1500};

  /// Listens on a free port of 127.0.0.1.
  FakeSidecar();
  ~FakeSidecar();
  FakeSidecar(const FakeSidecar&) = delete;
  FakeSidecar& operator=(const FakeSidecar&) = delete;

  std::uint16_t port() const { return port_; }
  void set(Mode mode);
  /// Stops to listen: connections are refused.
  void vanish();
  /// Listens again, at the same port.
  void comeBack();
  /// What an allocation of the fleet does to the game server, which has a place reserved then.
  void allocate();

  /// The calls that have taken effect, in order, such as "POST /ready {}".
  std::vector<std::string> calls();
  /// How many of them begin with this.
  std::size_t count(const std::string& call);
  /// All requests that have arrived, answered or not.
  std::size_t requests();
  /// The number of the newest request that waits for an answer, from 1 on; 0: none does.
  std::size_t unanswered();
  /// What the description of Agones does not allow in requests that have arrived.
  std::vector<std::string> faults();

 private:
  struct Connection {
    Descriptor socket;
    std::string received{};
    std::string response{};
    std::chrono::steady_clock::time_point answerAt{};  // not before
    bool answered = false;
    bool isSilent = false;
    std::size_t request = 0;  // its number
  };

  void run();
  void serve(Connection& connection);
  std::string answer(const std::string& request);
  std::string take(const SidecarRequest& request);
  std::string takePlayers(const SidecarRequest& request);
  void setState(const std::string& state);
  std::string gameServer() const;

  std::uint16_t port_ = 0;
  std::mutex mutex_;
  Descriptor listener_;  // this and all below: under the mutex
  Mode mode_ = Mode::kAnswers;
  std::vector<Connection> connections_;
  std::vector<std::string> calls_;
  std::vector<std::string> faults_;
  std::size_t requests_ = 0;
  std::string state_ = "Scheduled";  // of the game server
  int allocations_ = 0;              // all have different times
  std::int64_t players_ = 0;         // its counter
  std::int64_t places_ = 16;
  bool ended_ = false;
  std::thread thread_;  // last: uses the members above from its start
};

}  // namespace platon
