#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/desync/desync_report.h"
#include "client/files/session_file.h"
#include "client/hud/hud.h"
#include "client/lobby/known_servers.h"
#include "client/play/client_options.h"
#include "client/play/match/scene_feed.h"
#include "client/play/match/server_lines.h"
#include "client/replay/run_keeper.h"
#include "client/scene/scene.h"
#include "client/session/network_client.h"
#include "client/time/clock.h"
#include "client/ui/chat_feed.h"
#include "client/ui/settings.h"
#include "protocol/moment.h"

namespace platon {

/// The common part of playing with and without a window: runs the network client, creates scenes to draw, writes desync
/// reports, and keeps the token that resumes the player after a crash of the program.
class MatchPlay {
 public:
  static constexpr Moment kNoticeTime = std::chrono::seconds(8);

  /// Starts to connect, and resumes the player if the program ended without leaving. Throws std::runtime_error if the
  /// host name cannot be resolved or no socket is available, and ProgramError if the file of known servers is damaged.
  /// `rival`: a recording that is shown as a ghost on its level, whatever the settings; empty: none.
  MatchPlay(const ClientOptions& options, const ServerAddress& server, Moment now,
            const std::filesystem::path& rival = {});

  void update(Moment now, const Controls& controls);
  /// Empty before the first round. During an outage, the last scene.
  std::optional<Scene> scene(Moment now);
  /// Connection status for the player; empty while the match runs.
  std::string message() const;
  /// Text of the server's operator, for kNoticeTime after it was received; empty: none.
  std::string notice(Moment now) const;
  /// What the head-up display shows besides the scene.
  HudStatus hudStatus(Moment now, bool help) const;
  /// Wishes the next level, or takes this wish back.
  void toggleVote() { client_.toggleVote(); }
  /// Says something to all players. Returns false if this client has said too much, or is in no match.
  bool say(const Chat& chat, Moment now) { return client_.say(chat, now); }
  /// What players have said lately, newest first; empty if the settings hide it.
  std::vector<std::string> said() const { return chatShown_ ? chat_.newest() : std::vector<std::string>(); }
  /// Shows timer, ghosts and what players say as these settings tell.
  void show(const Settings& settings);
  /// Whether rounds have a time limit.
  void setTimed(bool timed) { sceneFeed_.setTimed(timed); }
  /// Whether the server has ended the round.
  bool roundOver() const { return client_.session() != nullptr && client_.session()->roundEnd() != nullptr; }
  /// Whether attempts may be kept (RunKeeper::countRuns).
  void countRuns(bool count) { runs_->countRuns(count); }
  /// Whether the local player wishes the next level.
  bool wishesNext() const { return client_.session() != nullptr && client_.session()->wishesNext(); }
  /// The present level; null before the first round.
  std::shared_ptr<const Level> level() const;
  /// The file of the local player's best run on the present level; empty: none.
  const std::filesystem::path& bestRun() const { return runs_->bestFile(); }
  /// Leaves the match; takes at most half a second.
  void leave(const Clock& clock);

  const NetworkClient& client() const { return client_; }

 private:
  void reportDesync(Moment now);
  void reportOutage(Moment now);
  void reportRuns();
  void takeNotice(Moment now);
  void takeChats(Moment now);
  std::vector<GhostSource> ghosts() const;
  void saveToken();
  void rememberServer();

  ServerAddress server_;
  bool ownServer_ = false;  // in this program
  std::shared_ptr<RunKeeper> runs_;
  SessionFile sessionFile_;
  KnownServers knownServers_;
  bool tokenSaved_ = false;
  bool serverRemembered_ = false;
  NetworkClient client_;
  SceneFeed sceneFeed_;
  bool timerShown_ = true;
  bool ghostsShown_ = true;
  bool hasRival_ = false;
  bool chatShown_ = true;
  ChatFeed chat_;
  DesyncFolder desyncFolder_;
  std::optional<Scene> lastScene_;
  std::optional<std::string> reportedOutage_;
  ServerLines lines_;
  std::string notice_;  // the newest one
  Moment noticeUntil_{};
};

}  // namespace platon
