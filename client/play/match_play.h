#pragma once

#include <optional>
#include <string>

#include "client/desync/desync_folder.h"
#include "client/play/client_options.h"
#include "client/play/finish_watch.h"
#include "client/play/scene_feed.h"
#include "client/play/session_file.h"
#include "client/scene/scene.h"
#include "client/session/relayed_client.h"
#include "client/time/clock.h"
#include "client/time/moment.h"

namespace platon {

/// What playing has in common with and without a window: the match over the network, what is drawn of it, what is told
/// on standard output, what is kept when the game was not the server's, and what it takes to come back after a crash of
/// the program. On a simulated line when one is asked for.
class MatchPlay {
 public:
  /// Begins to connect; when this program ended without leaving, as the same player. Throws std::runtime_error when
  /// that cannot even begin.
  MatchPlay(const ClientOptions& options, const ServerAddress& server, Moment now);

  void update(Moment now, const Controls& controls);
  /// Nothing before a round is played. While the connection is being made again, the last one.
  std::optional<Scene> scene(Moment now);
  /// State of the connection for the player; empty while all is well.
  std::string message() const;
  /// Says good-bye and gives that half a second to arrive.
  void leave(const Clock& clock);

  const NetworkClient& client() const { return *client_; }

 private:
  void reportDesync();
  void reportOutage();
  void keepToken();

  ServerAddress server_;
  SessionFile sessionFile_;
  bool tokenKept_ = false;
  RelayedClient client_;
  SceneFeed feed_;
  FinishWatch watch_;
  DesyncFolder desyncs_;
  std::optional<Scene> lastScene_;
  std::optional<std::string> toldOutage_;
};

}  // namespace platon
