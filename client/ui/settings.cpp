#include "client/ui/settings.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <functional>
#include <iterator>
#include <optional>
#include <sstream>

#include "client/ui/ball_choice_text.h"
#include "client/ui/controls/bindings_text.h"

namespace platon {
namespace {

// By CameraView.
constexpr std::array<std::string_view, 3> kCameraWords{"follow", "face", "face-fade"};

// Stands for an empty text.
constexpr std::string_view kNone = "none";

constexpr double kMinTurnSpeed = 1;
constexpr double kMaxTurnSpeed = 30;
constexpr double kMinZoom = 0.5;
constexpr double kMaxZoom = 2;
constexpr double kMaxFrameCap = 1000;
constexpr double kMaxVolume = 100;
constexpr double kMinGameSpeed = 50;

// Each `parse` stores a valid value and returns true; otherwise it changes nothing and returns false.
bool parse(std::string_view value, bool& flag) {
  if (value != "on" && value != "off") return false;
  flag = value == "on";
  return true;
}

bool parse(std::string_view value, double& number, double min, double max) {
  double parsed = 0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), parsed);
  if (error != std::errc() || end != value.data() + value.size()) return false;
  if (!(parsed >= min && parsed <= max)) return false;
  number = parsed;
  return true;
}

bool parse(std::string_view value, ControlFrame& frame) {
  if (value != "player" && value != "screen") return false;
  frame = value == "screen" ? ControlFrame::kScreen : ControlFrame::kPlayer;
  return true;
}

bool parse(std::string_view value, CameraView& view) {
  const auto found = std::find(kCameraWords.begin(), kCameraWords.end(), value);
  if (found == kCameraWords.end()) return false;
  view = static_cast<CameraView>(found - kCameraWords.begin());
  return true;
}

bool isReadable(std::string_view word) {
  return std::all_of(word.begin(), word.end(), [](char byte) { return byte > ' ' && byte <= '~'; });
}

bool parseListUrl(std::string_view value, std::string& url) {
  if (value != kNone && !isListUrl(value)) return false;
  url = value == kNone ? "" : value;
  return true;
}

// One setting of the file. `parse` stores a valid value.
struct Entry {
  std::string_view name;
  std::string allowed;
  std::function<bool(std::string_view)> parse;
};

std::vector<Entry> entriesOf(Settings& settings) {
  const auto flag = [](std::string_view name, bool& target) {
    return Entry{name, "on or off", [&target](std::string_view value) { return parse(value, target); }};
  };
  const auto volume = [](std::string_view name, double& target) {
    return Entry{name, "a number from 0 to 100",
                 [&target](std::string_view value) { return parse(value, target, 0, kMaxVolume); }};
  };
  CameraComfort& comfort = settings.comfort;
  return {
      {"turn-speed", "a number from 1 to 30",
       [&comfort](std::string_view value) { return parse(value, comfort.turnRate, kMinTurnSpeed, kMaxTurnSpeed); }},
      {"camera", "follow, face or face-fade",
       [&comfort](std::string_view value) { return parse(value, comfort.view); }},
      {"zoom", "a number from 0.5 to 2",
       [&settings](std::string_view value) { return parse(value, settings.zoom, kMinZoom, kMaxZoom); }},
      {"text-size", "a number from 0.75 to 1.75",
       [&settings](std::string_view value) { return parse(value, settings.uiScale, kMinUiScale, kMaxUiScale); }},
      {"controls", "player or screen", [&settings](std::string_view value) { return parse(value, settings.controls); }},
      flag("toggle-slow", settings.toggled.slow),
      flag("toggle-look", settings.toggled.look),
      flag("instant-cut", comfort.instantCut),
      flag("reduced-motion", comfort.reducedMotion),
      {"ball-colour", ballColourWords(),
       [&settings](std::string_view value) { return platon::parse(value, settings.ball.colour); }},
      {"ball-pattern", ballPatternWords(),
       [&settings](std::string_view value) { return platon::parse(value, settings.ball.pattern); }},
      flag("flashes", settings.flashes),
      flag("high-contrast", settings.highContrast),
      {"quality", "auto, low, medium, high or all",
       [&settings](std::string_view value) { return parseLevel(value, settings.quality); }},
      {"render-scale", "a number from 0.5 to 1",
       [&settings](std::string_view value) { return parseScale(value, settings.quality); }},
      {"multisampling", "1, 2 or 4",
       [&settings](std::string_view value) { return parseSamples(value, settings.quality); }},
      flag("fullscreen", settings.fullscreen),
      flag("vsync", settings.vsync),
      {"frame-cap", "a number from 0 to 1000",
       [&settings](std::string_view value) { return parse(value, settings.frameCap, 0, kMaxFrameCap); }},
      {"game-speed", "a number from 50 to 100",
       [&settings](std::string_view value) { return parse(value, settings.gameSpeed, kMinGameSpeed, 100); }},
      flag("net-graph", settings.netGraph),
      flag("face-numbers", settings.faceNumbers),
      flag("chat", settings.chat),
      flag("first-keys", settings.firstKeys),
      {"element-hints", "none, or words of elements with commas between",
       [&settings](std::string_view value) { return platon::parse(value, settings.untold); }},
      {"list-url", std::string("none, or ") + kListUrlForm,
       [&settings](std::string_view value) { return parseListUrl(value, settings.listUrl); }},
      volume("volume", settings.volume),
      volume("volume-effects", settings.effectsVolume),
      volume("volume-music", settings.musicVolume),
      flag("timer", settings.timer),
      flag("ghosts", settings.ghosts)};
}

using Words = std::vector<std::string>;

// What is wrong with the line of a setting; nothing if the line names no setting.
std::optional<std::string> faultOf(const Words& words, Settings& settings, BindingsReader& bindings) {
  const std::span<const std::string> values = std::span(words).subspan(1);
  const std::optional<Control> control = words[0] == "key" && !values.empty() ? controlNamed(values[0]) : std::nullopt;
  if (control) {
    const std::string fault = bindings.read(*control, values.subspan(1));
    return fault.empty() ? fault : "key " + values[0] + " " + fault;
  }
  for (const Entry& entry : entriesOf(settings)) {
    if (entry.name != words[0]) continue;
    return values.size() == 1 && entry.parse(values[0]) ? "" : words[0] + " must be " + entry.allowed;
  }
  return std::nullopt;
}

// A name from outside goes to the terminal only if it can be read there.
std::string unknown(const std::string& name) {
  constexpr std::size_t kMaxShown = 40;
  return name.size() <= kMaxShown && isReadable(name) ? "unknown setting '" + name + "'" : "unknown setting";
}

void parseLine(const std::string& line, const std::string& where, SettingsResult& result, BindingsReader& bindings) {
  std::istringstream stream(line);
  const Words words{std::istream_iterator<std::string>(stream), std::istream_iterator<std::string>()};
  if (words.empty()) return;
  const std::optional<std::string> fault = faultOf(words, result.settings, bindings);
  if (!fault) result.unknownLines.push_back(line);
  if (!fault)
    result.errors.push_back(where + unknown(words[0]));
  else if (!fault->empty())
    result.errors.push_back(where + *fault);
}

const char* onOff(bool flag) { return flag ? "on" : "off"; }

}  // namespace

bool isListUrl(std::string_view text) {
  const std::size_t scheme = text.starts_with("https://") ? 8 : text.starts_with("http://") ? 7 : text.size();
  return text.size() > scheme && text.size() <= kMaxListUrlBytes && isReadable(text);
}

std::string Settings::text() const {
  std::ostringstream out;
  out << "turn-speed " << comfort.turnRate << "\n";
  out << "instant-cut " << onOff(comfort.instantCut) << "\n";
  out << "reduced-motion " << onOff(comfort.reducedMotion) << "\n";
  out << "ball-colour " << wordOf(ball.colour) << "\n";
  out << "ball-pattern " << wordOf(ball.pattern) << "\n";
  out << "flashes " << onOff(flashes) << "\n";
  out << "high-contrast " << onOff(highContrast) << "\n";
  out << "controls " << (controls == ControlFrame::kScreen ? "screen" : "player") << "\n";
  out << "camera " << kCameraWords.at(static_cast<std::size_t>(comfort.view)) << "\n";
  out << "zoom " << zoom << "\n";
  out << "text-size " << uiScale << "\n";
  out << quality.text();
  out << "fullscreen " << onOff(fullscreen) << "\n";
  out << "vsync " << onOff(vsync) << "\n";
  out << "frame-cap " << frameCap << "\n";
  out << "game-speed " << gameSpeed << "\n";
  out << "net-graph " << onOff(netGraph) << "\n";
  out << "face-numbers " << onOff(faceNumbers) << "\n";
  out << "chat " << onOff(chat) << "\n";
  out << "first-keys " << onOff(firstKeys) << "\n";
  out << "element-hints " << textOf(untold) << "\n";
  out << "list-url " << (listUrl.empty() ? kNone : listUrl) << "\n";
  out << "volume " << volume << "\n";
  out << "volume-effects " << effectsVolume << "\n";
  out << "volume-music " << musicVolume << "\n";
  out << "timer " << onOff(timer) << "\n";
  out << "ghosts " << onOff(ghosts) << "\n";
  out << "toggle-slow " << onOff(toggled.slow) << "\n";
  out << "toggle-look " << onOff(toggled.look) << "\n";
  out << textOf(bindings);
  return out.str();
}

SettingsResult parseSettings(std::string_view text) {
  SettingsResult result;
  std::istringstream lines{std::string(text)};
  std::string line;
  BindingsReader bindings;
  for (int number = 1; std::getline(lines, line); ++number) {
    parseLine(line, "line " + std::to_string(number) + ": ", result, bindings);
  }
  result.settings.bindings = bindings.bindings();
  return result;
}

}  // namespace platon
