#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "client/audio/audio.h"
#include "client/audio/sound_cues.h"
#include "client/hud/net_graph.h"
#include "client/menu/menu.h"
#include "client/scene/scene.h"
#include "client/scene/stage_model.h"
#include "client/session/network_client.h"
#include "client/session/session.h"
#include "client/ui/settings.h"
#include "protocol/time.h"

// What a session brings: the scene to draw, the sounds, and the samples of the net graph.
namespace platon {

/// What a scene shows besides what the session knows.
struct SceneExtras {
  std::size_t local = 0;                             ///< local number of the player whose scene it is; it has a slot
  bool timed = true;                                 ///< rounds have a time limit
  std::array<BallChoice, kMaxLocalPlayers> balls{};  ///< how the local players want their balls
  std::vector<GhostSource> ghosts{};                 ///< that play along
};

/// Creates the scene to draw from a session.
class SceneFeed {
 public:
  /// Returns nothing while the session has no round.
  std::optional<Scene> scene(const Session& session, Time now, SceneExtras extras = {});

 private:
  void updateFlashes(const Round& round);
  void updateRoundTrips(const Session& session, Time now);

  std::shared_ptr<const Level> level_;
  std::shared_ptr<const StageModel> stage_;               // of level_
  std::vector<double> flashes_;                           // by slot
  std::vector<std::optional<std::uint32_t>> roundTrips_;  // by slot, ms
};

/// Makes a session and the menu heard.
class SoundFeed {
 public:
  explicit SoundFeed(Audio::Open open = &OpenalOutput::open) : audio_(std::move(open)) {}

  /// Plays what the menu has done since the last frame.
  void menu(Menu::Feedback feedback);
  /// Plays what a frame brings, `seconds` after the last one. `session` and `scene`: null while there is none, also
  /// during an outage. `nextRoundSeconds`: until the next round starts, if that is known.
  void update(const Session* session, const Scene* scene, std::optional<double> nextRoundSeconds,
              const Settings& settings, double seconds);

  Audio& audio() { return audio_; }

 private:
  Audio audio_;
  SoundCues cues_;
};

/// Samples the state of a connection, and how often pictures are drawn, for the net graph.
class NetMeter {
 public:
  /// Call once per frame. `now` goes on also while the game is paused. Rates are averages over the last second. The
  /// client must have a session.
  NetSample sample(const NetworkClient& client, Time now);

 private:
  struct Reading {
    Time at;
    Traffic traffic;  // total
  };

  std::deque<Reading> readings_;  // of the last second, oldest first
  std::uint32_t corrections_ = 0;
};

}  // namespace platon
