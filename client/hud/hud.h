#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "client/hud/net_graph.h"
#include "client/hud/results_panel.h"
#include "client/scene/camera.h"
#include "client/scene/scene.h"
#include "client/ui/controls/key_names.h"
#include "client/ui/font.h"
#include "client/ui/medal.h"
#include "client/ui/overlay.h"
#include "client/ui/run_timer.h"

namespace platon {

/// The vote for the next level.
struct VoteStatus {
  std::uint32_t votes = 0;  ///< at least 1
  std::uint32_t voters = 0;
  bool mine = false;  ///< the local player has voted
};

/// What the head-up display shows besides the scene.
struct HudStatus {
  std::string message{};                  ///< state of the connection or why the game ended; empty: none
  bool warning = false;                   ///< the message reports an error
  bool help = false;                      ///< show the table of keys
  std::string notice{};                   ///< text of the server's operator; empty: none
  std::optional<VoteStatus> vote{};       ///< nothing: nobody has voted
  std::optional<RoundSummary> summary{};  ///< nothing: the round has not ended
  std::optional<MedalTimes> medals{};     ///< of the level, once its goal is reached; nothing: none is told
  RunStatus run{};                        ///< how the attempt compares with the best run
  bool timer = true;                      ///< show the own time and `run`
  std::vector<std::string> chat{};        ///< what players have said lately, oldest first
  KeyHints keys{};                        ///< the keys that texts name
  std::vector<KeyHints> companionKeys{};  ///< those of the other local players who see the game, in their order
  std::string hint{};                     ///< what the player may do next; empty: nothing
  float scale = 1;                        ///< of the display, as Settings::uiScale
  float foot = 0;                         ///< height at the lower edge that is taken, of the virtual screen at scale 1
  const NetGraph* netGraph = nullptr;     ///< to be shown; null: none
  bool underMenu = false;                 ///< a menu covers the display: only messages and notices are shown
  bool assembling = false;                ///< the solid is not complete: nothing points to places on it
};

/// Time left as `minutes:seconds`; below ten seconds with tenths. `seconds` ≥ 0.
std::string clockText(double seconds);

/// The display while there is no game. `width` is that of the virtual screen at scale 1.
Overlay makeEmptyHud(const HudStatus& status, const Font& font, float width);

/// A notice alone, at the lower edge of a virtual screen of this width at scale 1; `scale`: as HudStatus::scale.
Overlay makeNotice(const std::string& notice, const Font& font, float width, float scale);

/// A part of the screen in which a local player sees the game, beside those of others.
struct HudPane {
  const Scene* scene = nullptr;
  const Camera* camera = nullptr;
  glm::vec2 corner{0};  ///< the upper left one, on the virtual screen
  glm::vec2 size{0};
  bool namesAll = false;  ///< also the local player has a name tag: others of this machine see the pane, too
};

/// Title, clock, the local player's own time, list of players, name tags, signs of what is out of the picture, results,
/// vote, message, notice, hint, graph and help. Nothing overlaps and all is on the screen; what finds no room is
/// shortened or left out.
Overlay makeHud(const Scene& scene, const Camera& camera, const HudStatus& status, const Font& font);
/// The same for several local players, of whom the first pane has the first one: each pane has its own name tags and
/// signs, its player's name, and says when its player must go back to the start. `width`: of the virtual screen at
/// scale 1.
Overlay makeSharedHud(std::span<const HudPane> panes, const HudStatus& status, const Font& font, float width);

/// Where the border of the screen shows that something lies beyond it.
struct EdgeSign {
  glm::vec2 direction{0};       ///< from the middle of the screen, of length 1, +y down
  glm::vec2 place{0};           ///< on a rectangle around the middle of the screen
  const char* arrow = nullptr;  ///< the arrow that comes nearest to the direction
};

/// The sign of a point that is projected to `clip`; nothing if the picture shows it. `reach`: half the size of the
/// rectangle on which signs stand, at most half of `screen`.
std::optional<EdgeSign> edgeSignOf(glm::dvec4 clip, glm::vec2 screen, glm::vec2 reach);

/// Adds the table of keys, buttons and their meaning at the lower left. `companions`: HudStatus::companionKeys.
/// `brief`: with one key or button of each control.
void addHelp(OverlayWriter& writer, const KeyHints& keys, std::span<const KeyHints> companions, bool brief);

}  // namespace platon
