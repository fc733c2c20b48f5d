#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "client/desync/desync_report.h"
#include "client/files/server_files.h"
#include "client/hud/hud.h"
#include "client/lobby/remembered.h"
#include "client/play/client_options.h"
#include "client/play/match/embedded_server.h"
#include "client/play/match/session_feeds.h"
#include "client/replay/run_keeper.h"
#include "client/scene/scene.h"
#include "client/session/network_client.h"
#include "client/time/clock.h"
#include "client/ui/chat_feed.h"
#include "client/ui/settings.h"
#include "platon/game/player.h"
#include "protocol/texts.h"
#include "protocol/time.h"
#include "protocol/token_bucket.h"
#include "protocol/transport/server_address.h"
#include "protocol/transport/server_identity.h"

namespace platon {

/// What to play.
struct MatchChoice {
  std::optional<ServerAddress> server{};  ///< nothing: a server in this program
  Password password{};                    ///< of that server
  std::optional<CryptoKey> key{};         ///< of that server, from a list; nothing: the one that the client remembers
  EmbeddedSettings own{};                 ///< of the server in this program
  std::string name{};                     ///< of the player, unless the options name one; empty: the server chooses it
  std::filesystem::path rival{};          ///< a recording that runs as a ghost, whatever the settings; empty: none
};

/// The least speed at which the game has run during the present attempt of a player, up to the goal.
class AttemptSpeed {
 public:
  /// The game of this round has run at this speed, 0.5 … 1, since the last call; `player` is its present state.
  void observe(std::uint32_t round, const PlayerState& player, double speed) {
    const bool begins = player.startedAt == 0 || player.startedAt != startedAt_ || round != round_;
    if (begins) {
      least_ = speed;
    } else if (player.arrived == 0) {
      least_ = std::min(least_, speed);
    }
    round_ = round;
    startedAt_ = player.startedAt;
  }

  double least() const { return least_; }

 private:
  std::uint32_t round_ = 0;
  std::uint32_t startedAt_ = 0;  // as PlayerState
  double least_ = 1;
};

/// Lines on standard error about what a server does, no more than somebody can read: a hostile server would otherwise
/// fill a disk with them. How many are left out is told.
class ServerLines {
 public:
  using Print = std::function<void(const std::string&)>;

  static constexpr double kLinesPerSecond = 1;
  static constexpr double kBurst = 10;
  /// Between the first line that is left out and the line that tells their number.
  static constexpr Time kTellTime = std::chrono::seconds(10);

  /// `print` takes a line without its end.
  explicit ServerLines(Time now, Print print = toStderr)
      : budget_(kLinesPerSecond, kBurst, now), print_(std::move(print)) {}

  /// Prints a line, or leaves it out.
  void add(const std::string& line, Time now) {
    if (budget_.take(1, now)) return print_(line);
    if (leftOut_++ == 0) tellAt_ = now + kTellTime;
  }
  /// Tells how many lines were left out, when it is time. Call it regularly.
  void update(Time now) {
    if (now >= tellAt_) tell();
  }
  /// Tells it at once; nothing if none were.
  void tell() {
    if (leftOut_ == 0) return;
    print_(counted(leftOut_, "line") + " about the server left out: there were too many");
    leftOut_ = 0;
  }

 private:
  static void toStderr(const std::string& line) { std::fprintf(stderr, "platon-client: %s\n", line.c_str()); }

  TokenBucket budget_;
  Print print_;
  std::size_t leftOut_ = 0;
  Time tellAt_{};
};

/// What is kept of a server elsewhere from one match to the next: its key, and the token that resumes the players after
/// a crash of the program.
class ServerMemory {
 public:
  /// `choice.server` is given.
  explicit ServerMemory(const MatchChoice& choice);

  /// What a client knows of the server. Throws ProgramError if the file of known servers is damaged.
  ServerKnowledge knowledge() const;
  std::optional<SessionToken> token() const { return session_.token(); }
  /// Keeps the key and the token as soon as the client is welcome.
  void keep(const NetworkClient& client);
  /// The player has left: nobody is to be resumed.
  void forgetToken() { session_.forget(); }

 private:
  ServerAddress server_;
  ServerKnowledge given_;
  KnownServers known_;
  SessionFile session_;
  bool tokenKept_ = false;
  bool keyKept_ = false;
};

/// A match that is played, with or without a window: the client and, unless it is on another server, the server that
/// runs it. Both go by one clock, which stands still while a player who is alone pauses. It keeps runs and reached
/// levels, writes desync reports, and says what is to be seen.
class LiveMatch {
 public:
  static constexpr Time kNoticeTime = std::chrono::seconds(8);

  /// Starts the server, if it is in this program, and starts to connect; resumes the player if the program ended
  /// without leaving. Throws as startServer does, std::runtime_error if the host name cannot be resolved or no
  /// socket is available, and ProgramError if the file of known servers is damaged.
  LiveMatch(const ClientOptions& options, const MatchChoice& choice, const Clock& clock);

  /// `wantsPause`: the match pauses as far as nobody else plays in it. `speed`, 0.5 … 1: that of the game while nobody
  /// else plays on the server in this program. The time and the run of an attempt in which it was less than 1 count for
  /// nothing.
  void update(bool wantsPause, const Controls& controls, double speed = 1);
  /// Leads to the next level: at once for a player who is alone, else by a vote, or taking it back.
  void skipLevel();
  /// A local player says something to all players. Returns false if it has said too much, or is in no match.
  bool say(const Chat& chat, std::uint32_t local = 0) { return client_.say(chat, now(), local); }
  /// Another player of this program joins, takes another name, or leaves (NetworkClient::setCompanion).
  void setCompanion(std::uint32_t local, const std::optional<std::string>& name) { client_.setCompanion(local, name); }
  /// Leaves the match; takes at most half a second.
  void leave();

  const NetworkClient& client() const { return client_; }
  /// Time of the match: stands still in a pause.
  Time now() const { return time_->now(); }
  /// Whether the game stands still.
  bool paused() const { return time_->paused(); }
  /// Whether the server is in this program and nobody else plays on it.
  bool alone() const { return server_ && server_->clients() <= 1; }
  /// Whether a player who is alone has all the time it wants, and starts the next level itself: the server decides it.
  bool waits() const { return server_ && server_->waits(); }
  /// Whether the server has ended the round.
  bool roundOver() const { return client_.session() != nullptr && client_.session()->roundEnd() != nullptr; }
  /// Whether a player who is alone has nothing to lose by the next level: the goal is reached, or not to be reached.
  bool losesNothing() const;
  /// Whether the local player wishes the next level.
  bool wishesNext() const { return client_.session() != nullptr && client_.session()->wishesNext(); }
  /// The present level; null before the first round.
  std::shared_ptr<const Level> level() const;
  /// The file of the local player's best run on the present level; empty: none.
  const std::filesystem::path& bestRun() const { return runs_->bestFile(); }
  /// The least speed of the present attempt.
  double leastSpeed() const { return attempt_.least(); }

  /// The slots of the local players; none before the first round.
  SlotsByLocal slots() const;
  /// As this local player sees it. Empty before the first round, and if it has no slot. During an outage, the last
  /// scene.
  std::optional<Scene> scene(const Settings& settings = {}, std::size_t local = 0);
  /// What the head-up display shows besides the scene.
  HudStatus hudStatus(const Settings& settings = {}, bool help = false) const;
  /// Connection status for the player; empty while the match runs.
  std::string message() const;
  /// What players have said lately, newest first; empty if the settings hide it.
  std::vector<std::string> said(const Settings& settings) const;
  /// What to tell others so that they can join, a paragraph each; empty unless the server in this program listens to
  /// the network.
  std::vector<std::string> invitation() const;
  /// Of a server in this program that listens, for a client on this machine.
  ServerAddress serverAddress() const { return {"127.0.0.1", *server_->port()}; }

 private:
  // Text of the server's operator.
  struct Notice {
    std::string text;
    Time until{};
  };

  void exchange(Time now, const Controls& controls);
  void run(double speed);
  void noteGoal();
  void report();
  void reportRuns();
  void noteChats();
  std::vector<GhostSource> ghosts(const Settings& settings) const;

  MatchChoice choice_;
  Clock clock_;
  std::shared_ptr<PausableClock> time_;
  std::unique_ptr<OwnServer> server_;   // null: it is elsewhere
  std::optional<ServerMemory> memory_;  // of a server elsewhere
  bool demo_;                           // the program plays, not the user
  std::shared_ptr<RunKeeper> runs_;
  NetworkClient client_;
  ReachedLevels reached_;
  AttemptSpeed attempt_;
  std::optional<std::uint32_t> asked_;  // the round whose end the player who is alone has asked for
  SceneFeed sceneFeed_;
  std::array<std::optional<Scene>, kMaxLocalPlayers> lastScenes_;  // by local number
  ChatFeed chat_;
  EmoteBubbles bubbles_;
  Notice notice_;  // the newest one
  ServerLines lines_;
  DesyncFolder desyncFolder_;
  std::optional<std::string> reportedOutage_;
};

}  // namespace platon
