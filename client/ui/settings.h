#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "client/quality/quality.h"
#include "client/scene/camera_controls.h"
#include "client/scene/palette.h"
#include "client/ui/controls/bindings.h"
#include "client/ui/hints/element_hints.h"

namespace platon {

/// Whether a text is a list of servers on a web server: kListUrlForm.
bool isListUrl(std::string_view text);
/// Whether a player may have this name: a label of at most kMaxNameBytes, but not `none`, the word for no name of the
/// settings file.
bool isPlayerName(std::string_view text);
/// What others see of what a player types becomes its name; nothing takes the name away. Another text changes nothing.
void takeName(std::string_view typed, std::string& name);
inline constexpr const char* kListUrlForm =
    "a URL that begins with https:// or http://, of at most 512 bytes and without spaces";
inline constexpr std::size_t kMaxListUrlBytes = 512;

/// How several players of one machine see the game.
enum class SharedViews : std::uint8_t {
  kOne,  ///< in one view while it can show all of them, else each in its own
  kEach  ///< each in its own
};

/// Another player of this machine.
struct CompanionChoice {
  std::string name;  ///< a label of at most kMaxNameBytes; empty: the server chooses one
  BallChoice ball;   ///< as all on this machine see it
};

/// The player's settings. Each may change at any time. settingTable() says what each may be.
struct Settings {
  SharedViews views = SharedViews::kOne;
  CameraComfort comfort;
  ControlFrame controls = ControlFrame::kPlayer;
  Bindings bindings;
  Bindings secondKeys{KeySet::kSecond};  ///< of the second player at the keyboard
  ToggledControls toggled;
  double zoom = 1;
  double uiScale = 1;  ///< size of the menus and the display
  QualityChoice quality;
  bool fullscreen = false;
  bool vsync = true;       ///< pictures wait for the screen
  double frameCap = 0;     ///< pictures a second at most; 0: any number
  double gameSpeed = 100;  ///< percent, for who is alone on the own machine
  bool netGraph = false;
  bool chat = true;            ///< shows what players say
  bool firstKeys = true;       ///< shows the first keys until they were used
  bool firstDown = true;       ///< shows once that down has turned on a face
  bool firstLook = true;       ///< shows how to look round until the player has done it
  UntoldElements untold;       ///< shows what these elements do until the ball has met one of each
  double volume = 80;          ///< of all sound, in percent
  double effectsVolume = 100;  ///< of the sounds of events
  double musicVolume = 70;
  bool timer = true;       ///< show the own time, its differences to the best run, and the personal best
  bool ghosts = true;      ///< show the best run and those of others
  BallChoice ball;         ///< of the own ball, as this player sees it
  CompanionChoice second;  ///< by local number: 1 is the second player, as the next ones
  CompanionChoice third;
  CompanionChoice fourth;
  bool flashes = true;        ///< players and goal flash
  bool highContrast = false;  ///< black ground, white walls and opaque panels
  bool faceNumbers = false;   ///< faces show their numbers instead of signs
  std::string name;           ///< of the player, a label of at most kMaxNameBytes; empty: the server chooses one
  std::string listUrl;        ///< isListUrl, or empty: no list

  /// Of the companion with this local number, 1 … kMaxLocalPlayers - 1.
  CompanionChoice& companion(std::size_t local) { return local == 1 ? second : local == 2 ? third : fourth; }
  const CompanionChoice& companion(std::size_t local) const {
    return local == 1 ? second : local == 2 ? third : fourth;
  }

  /// The settings as lines `name value…`, the format of `parseSettings`.
  std::string text() const;
};

struct SettingsResult {
  Settings settings;                      ///< defaults where the text has no valid line
  std::vector<std::string> errors;        ///< one for each invalid line: its number, what is wrong and what is allowed
  std::vector<std::string> unknownLines;  ///< lines that name no setting of this version, unchanged
};

/// Parses settings. An invalid line does not affect the others.
SettingsResult parseSettings(std::string_view text);

}  // namespace platon
