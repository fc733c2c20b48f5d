#include "client/ui/setting_table.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <sstream>
#include <type_traits>
#include <utility>

#include "protocol/limits.h"

namespace platon {
namespace {

// Stands for an empty text.

constexpr std::array<NamedValue, 5> kTurnSpeeds{
    {{2, "very slow"}, {4, "slow"}, {7, "normal"}, {12, "fast"}, {30, "very fast"}}};
constexpr std::array<NamedValue, 6> kFrameCaps{
    {{0, "none"}, {30, "30 fps"}, {60, "60 fps"}, {120, "120 fps"}, {144, "144 fps"}, {240, "240 fps"}}};

// By ControlFrame and by CameraView.
constexpr std::array<SettingWord, 2> kFrames{{{"player", "of the ball"}, {"screen", "of the screen"}}};
constexpr std::array<SettingWord, 2> kSharedViews{{{"one", "one for all"}, {"each", "one each"}}};
constexpr std::array<SettingWord, 3> kViews{
    {{"follow", "follows you"}, {"face", "stands still, cuts"}, {"face-fade", "stands still, fades"}}};

// None chosen, and then by the index of the colour and by BallPattern.
constexpr SettingWord kByNumber{"auto", "by your number"};
constexpr std::array<SettingWord, kBallColours + 1> kColours{
    {kByNumber, {"orange", "orange"}, {"blue", "blue"}, {"green", "green"}, {"rose", "rose"}, {"cream", "cream"}}};
constexpr std::array<SettingWord, kBallPatterns + 1> kPatterns{{kByNumber,
                                                                {"spots", "spots"},
                                                                {"stripes", "stripes"},
                                                                {"belt", "belt"},
                                                                {"cross", "cross"},
                                                                {"dots", "dots"},
                                                                {"halves", "halves"},
                                                                {"checks", "checks"},
                                                                {"plain", "plain"}}};
constexpr std::array<const char*, 2> kHeld{"while the key is held", "toggled by the key"};

// The value at the end of a path of members.
template <auto... kPath>
constexpr auto& at(auto& settings) {
  return (settings.*....*kPath);
}
template <auto... kPath>
using ValueAt = std::remove_reference_t<decltype(at<kPath...>(std::declval<Settings&>()))>;

template <auto... kPath>
constexpr SettingMember<ValueAt<kPath...>> member() {
  using Value = ValueAt<kPath...>;
  return {[](Settings& settings) -> Value& { return at<kPath...>(settings); },
          [](const Settings& settings) -> const Value& { return at<kPath...>(settings); }};
}

// An enumeration; the words are by its values.
template <auto... kPath>
constexpr SettingWords oneOf(std::span<const SettingWord> words) {
  return {[](const Settings& settings) { return static_cast<std::size_t>(at<kPath...>(settings)); },
          [](Settings& settings, std::size_t index) { at<kPath...>(settings) = static_cast<ValueAt<kPath...>>(index); },
          words};
}

// An optional value; the first word is for none.
template <auto... kPath>
constexpr SettingWords noneOrOneOf(std::span<const SettingWord> words) {
  using Value = typename ValueAt<kPath...>::value_type;
  return {[](const Settings& settings) {
            const std::optional<Value>& value = at<kPath...>(settings);
            return value ? static_cast<std::size_t>(*value) + 1 : 0;
          },
          [](Settings& settings, std::size_t index) {
            at<kPath...>(settings) = index == 0 ? std::nullopt : std::optional(static_cast<Value>(index - 1));
          },
          words, ", "};
}

constexpr const char* kNameForm = "a text of at most 32 bytes without control characters";
static_assert(kMaxNameBytes == 32, "the form of a name says so");
bool isName(std::string_view text) { return !text.empty() && isPlayerName(text); }

constexpr SettingNumber volume(SettingMember<double> member) { return {member, 0, 100, 5, 1}; }

using S = Settings;
using Comfort = CameraComfort;
using Group = SettingGroup;

constexpr std::array kSettings{
    Setting{.name = "fullscreen",
            .line = 14,
            .value = SettingFlag{member<&S::fullscreen>()},
            .group = Group::kPicture,
            .label = "Full screen",
            .about = "Fills the whole screen. F11 does the same."},
    Setting{.name = "vsync",
            .line = 15,
            .value = SettingFlag{member<&S::vsync>()},
            .group = Group::kPicture,
            .label = "VSync",
            .about = "Shows each picture when the screen is ready, so that none is torn."},
    Setting{.name = "frame-cap",
            .line = 16,
            .value = SettingNumber{.member = member<&S::frameCap>(), .min = 0, .max = 1000, .choices = kFrameCaps},
            .group = Group::kPicture,
            .label = "Frame rate limit",
            .about = "Draws no more pictures a second than this, which saves power."},
    Setting{.name = "quality",
            .line = 11,
            .value = QualityPart::kLevel,
            .group = Group::kPicture,
            .label = "Quality",
            .about = "How finely the picture is drawn. Choose a lower one if the game is not smooth."},
    Setting{.name = "render-scale",
            .line = 12,
            .value = QualityPart::kScale,
            .group = Group::kPicture,
            .label = "Render scale",
            .about = "Draws fewer pixels and enlarges them: faster, but less sharp."},
    Setting{.name = "multisampling",
            .line = 13,
            .value = QualityPart::kSamples,
            .group = Group::kPicture,
            .label = "Multisampling",
            .about = "Smooths the edges of walls and balls. More samples take longer."},
    Setting{.name = "zoom",
            .line = 9,
            .value = SettingNumber{.member = member<&S::zoom>(), .min = 0.5, .max = 2, .step = 0.05},
            .group = Group::kPicture,
            .label = "Zoom",
            .about = "How near the camera is to your ball.",
            .inMotion = true},
    Setting{.name = "text-size",
            .line = 10,
            .value = SettingNumber{.member = member<&S::uiScale>(), .min = 0.75, .max = 1.75, .step = 0.05},
            .group = Group::kPicture,
            .label = "UI scale",
            .about = "The size of the menus and of all texts in the game.",
            .inMotion = true},
    Setting{.name = "face-numbers",
            .line = 19,
            .value = SettingFlag{member<&S::faceNumbers>()},
            .group = Group::kPicture,
            .label = "Numbers on faces",
            .about = "Faces show their numbers instead of signs.",
            .inMotion = true},
    Setting{.name = "ball-colour",
            .line = 3,
            .value = noneOrOneOf<&S::ball, &BallChoice::colour>(kColours),
            .group = Group::kPicture,
            .label = "Colour of your ball",
            .about = "The colour of your ball on your own screen.",
            .inMotion = true},
    Setting{.name = "ball-pattern",
            .line = 4,
            .value = noneOrOneOf<&S::ball, &BallChoice::pattern>(kPatterns),
            .group = Group::kPicture,
            .label = "Pattern of your ball",
            .about = "The pattern of your ball on your own screen.",
            .inMotion = true},
    Setting{.name = "volume",
            .line = 24,
            .value = volume(member<&S::volume>()),
            .group = Group::kSound,
            .label = "Master volume",
            .about = "How loud everything is. 0 % is silence."},
    Setting{.name = "volume-effects",
            .line = 25,
            .value = volume(member<&S::effectsVolume>()),
            .group = Group::kSound,
            .label = "Effects volume",
            .about = "How loud rolling, jumps, keys and doors are."},
    Setting{.name = "volume-music",
            .line = 26,
            .value = volume(member<&S::musicVolume>()),
            .group = Group::kSound,
            .label = "Music volume",
            .about = "How loud the music is."},
    Setting{.name = "camera",
            .line = 8,
            .value = oneOf<&S::comfort, &Comfort::view>(kViews),
            .group = Group::kComfort,
            .label = "Camera",
            .about = "Whether the camera follows you, or stands still in front of each face.",
            .inMotion = true},
    Setting{.name = "turn-speed",
            .line = 0,
            .value =
                SettingNumber{
                    .member = member<&S::comfort, &Comfort::turnRate>(), .min = 1, .max = 30, .choices = kTurnSpeeds},
            .group = Group::kComfort,
            .label = "Camera turn speed",
            .about = "How fast the picture turns upright after down has turned.",
            .inMotion = true},
    Setting{.name = "instant-cut",
            .line = 1,
            .value = SettingFlag{member<&S::comfort, &Comfort::instantCut>()},
            .group = Group::kComfort,
            .label = "Instant camera cut",
            .about = "The camera jumps to its new place instead of moving there.",
            .inMotion = true},
    Setting{.name = "reduced-motion",
            .line = 2,
            .value = SettingFlag{member<&S::comfort, &Comfort::reducedMotion>()},
            .group = Group::kComfort,
            .label = "Reduced motion",
            .about = "Moves the camera less and stops animations, against dizziness.",
            .inMotion = true},
    Setting{.name = "flashes",
            .line = 5,
            .value = SettingFlag{member<&S::flashes>()},
            .group = Group::kComfort,
            .label = "Flashes",
            .about = "Balls and the goal flash. Turn it off if flashing light troubles you.",
            .inMotion = true},
    Setting{.name = "high-contrast",
            .line = 6,
            .value = SettingFlag{member<&S::highContrast>()},
            .group = Group::kComfort,
            .label = "High contrast",
            .about = "White walls on black ground, and panels that nothing shines through.",
            .inMotion = true},
    Setting{.name = "controls",
            .line = 7,
            .value = oneOf<&S::controls>(kFrames),
            .group = Group::kControls,
            .label = "Left and right",
            .about = "Whether left and right are those of the ball, or those of your screen."},
    Setting{.name = "toggle-slow",
            .line = 29,
            .value = SettingFlag{member<&S::toggled, &ToggledControls::slow>(), kHeld},
            .group = Group::kControls,
            .label = "Run slower",
            .about = "Whether you hold the key, or press it once to begin and once to end."},
    Setting{.name = "toggle-look",
            .line = 30,
            .value = SettingFlag{member<&S::toggled, &ToggledControls::look>(), kHeld},
            .group = Group::kControls,
            .label = "Look round",
            .about = "Whether you hold the key, or press it once to begin and once to end."},
    Setting{.name = "timer",
            .line = 27,
            .value = SettingFlag{member<&S::timer>()},
            .group = Group::kGame,
            .label = "Timer",
            .about = "Shows the time of your attempt and your personal best.",
            .inMotion = true},
    Setting{.name = "ghosts",
            .line = 28,
            .value = SettingFlag{member<&S::ghosts>()},
            .group = Group::kGame,
            .label = "Ghosts",
            .about = "Shows your best run as a pale ball that runs along, and runs of others."},
    Setting{.name = "views",
            .line = 34,
            .value = oneOf<&S::views>(kSharedViews),
            .group = Group::kGame,
            .label = "Views of several players",
            .about = "One picture for all who play on this machine while it can show them, or one for each."},
    Setting{.name = "chat",
            .line = 20,
            .value = SettingFlag{member<&S::chat>()},
            .group = Group::kGame,
            .label = "Chat",
            .about = "Shows what other players say."},
    Setting{.name = "net-graph",
            .line = 18,
            .value = SettingFlag{member<&S::netGraph>()},
            .group = Group::kGame,
            .label = "Connection graph",
            .about = "Shows how good the connection to the server is. F3 does the same.",
            .inMotion = true},
    Setting{.name = "element-hints",
            .line = 22,
            .value = member<&S::untold>(),
            .group = Group::kGame,
            .label = "Hints for new players",
            .about = "Explains keys and elements when you meet them. Turned on, it begins anew."},
    Setting{.name = "game-speed",
            .line = 17,
            .value = SettingNumber{.member = member<&S::gameSpeed>(), .min = 50, .max = 100, .step = 5, .percent = 1},
            .group = Group::kGame,
            .label = "Game speed, alone",
            .about = "Slows the game down while you are alone. Slowed times do not count.",
            .inMotion = true,
            .onlyAlone = true},
    Setting{.name = "ball-colour-2",
            .line = 36,
            .value = noneOrOneOf<&S::second, &CompanionChoice::ball, &BallChoice::colour>(kColours),
            .group = Group::kCompanions,
            .label = "Colour of player 2",
            .about = "The colour of the ball of player 2 on this machine."},
    Setting{.name = "ball-pattern-2",
            .line = 37,
            .value = noneOrOneOf<&S::second, &CompanionChoice::ball, &BallChoice::pattern>(kPatterns),
            .group = Group::kCompanions,
            .label = "Pattern of player 2",
            .about = "The pattern of the ball of player 2 on this machine."},
    Setting{.name = "ball-colour-3",
            .line = 39,
            .value = noneOrOneOf<&S::third, &CompanionChoice::ball, &BallChoice::colour>(kColours),
            .group = Group::kCompanions,
            .label = "Colour of player 3",
            .about = "The colour of the ball of player 3 on this machine."},
    Setting{.name = "ball-pattern-3",
            .line = 40,
            .value = noneOrOneOf<&S::third, &CompanionChoice::ball, &BallChoice::pattern>(kPatterns),
            .group = Group::kCompanions,
            .label = "Pattern of player 3",
            .about = "The pattern of the ball of player 3 on this machine."},
    Setting{.name = "ball-colour-4",
            .line = 42,
            .value = noneOrOneOf<&S::fourth, &CompanionChoice::ball, &BallChoice::colour>(kColours),
            .group = Group::kCompanions,
            .label = "Colour of player 4",
            .about = "The colour of the ball of player 4 on this machine."},
    Setting{.name = "ball-pattern-4",
            .line = 43,
            .value = noneOrOneOf<&S::fourth, &CompanionChoice::ball, &BallChoice::pattern>(kPatterns),
            .group = Group::kCompanions,
            .label = "Pattern of player 4",
            .about = "The pattern of the ball of player 4 on this machine."},
    Setting{.name = "first-keys", .line = 21, .value = SettingFlag{member<&S::firstKeys>()}, .group = Group::kHidden},
    Setting{.name = "first-down", .line = 31, .value = SettingFlag{member<&S::firstDown>()}, .group = Group::kHidden},
    Setting{.name = "first-look", .line = 32, .value = SettingFlag{member<&S::firstLook>()}, .group = Group::kHidden},
    Setting{.name = "name",
            .line = 33,
            .value = SettingText{member<&S::name>(), &isName, kNameForm},
            .group = Group::kHidden},
    Setting{.name = "name-2",
            .line = 35,
            .value = SettingText{member<&S::second, &CompanionChoice::name>(), &isName, kNameForm},
            .group = Group::kHidden},
    Setting{.name = "name-3",
            .line = 38,
            .value = SettingText{member<&S::third, &CompanionChoice::name>(), &isName, kNameForm},
            .group = Group::kHidden},
    Setting{.name = "name-4",
            .line = 41,
            .value = SettingText{member<&S::fourth, &CompanionChoice::name>(), &isName, kNameForm},
            .group = Group::kHidden},
    Setting{.name = "list-url",
            .line = 23,
            .value = SettingText{member<&S::listUrl>(), &isListUrl, kListUrlForm},
            .group = Group::kHidden}};

// The rows in the order of the file. Does not compile if two have the same line, or one is out of the file.
constexpr std::array<const Setting*, kSettings.size()> kLines = [] {
  std::array<const Setting*, kSettings.size()> lines{};
  for (const Setting& setting : kSettings) lines.at(setting.line) = &setting;
  return lines;
}();
static_assert(std::find(kLines.begin(), kLines.end(), nullptr) == kLines.end(), "each line has a setting of its own");
static_assert(std::is_sorted(kSettings.begin(), kSettings.end(),
                             [](const Setting& a, const Setting& b) { return a.group < b.group; }),
              "settings of a group are beside each other");

constexpr bool hasItem(const Setting& setting) {
  const auto* const number = std::get_if<SettingNumber>(&setting.value);
  return *setting.label != 0 && *setting.about != 0 && (!number || number->step > 0 || !number->choices.empty());
}
static_assert(std::all_of(kSettings.begin(), kSettings.end(),
                          [](const Setting& setting) { return setting.group == Group::kHidden || hasItem(setting); }),
              "a setting of the menu has a label and a sentence about it, and its number has steps or choices");

constexpr bool hasOneRow(QualityPart part) {
  return std::count_if(kSettings.begin(), kSettings.end(), [part](const Setting& setting) {
           const auto* const shown = std::get_if<QualityPart>(&setting.value);
           return shown && *shown == part;
         }) == 1;
}
static_assert(std::all_of(kQualityParts.begin(), kQualityParts.end(), hasOneRow),
              "each part of the quality has one row");

std::optional<double> numberOf(std::string_view text) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

std::string textOf(double number) {
  std::ostringstream out;
  out << number;
  return out.str();
}

struct AllowedValues {
  std::string operator()(const SettingFlag&) const { return "on or off"; }
  std::string operator()(const SettingNumber& number) const {
    return "a number from " + textOf(number.min) + " to " + textOf(number.max);
  }
  std::string operator()(const SettingWords& setting) const {
    std::string text(setting.words.front().word);
    for (const SettingWord& word : setting.words.subspan(1)) {
      text += &word == &setting.words.back() ? setting.lastComma : ", ";
      text += word.word;
    }
    return text;
  }
  std::string operator()(QualityPart part) const { return std::string(allowedValues(part)); }
  std::string operator()(SettingMember<UntoldElements>) const {
    return "none, or words of elements separated by commas";
  }
  std::string operator()(const SettingText& text) const { return std::string("none, or ") + text.form; }
};

struct SettingReader {
  std::string_view text;
  Settings& settings;

  bool operator()(const SettingFlag& flag) const {
    if (text != "on" && text != "off") return false;
    flag.member.in(settings) = text == "on";
    return true;
  }
  bool operator()(const SettingNumber& number) const {
    const std::optional<double> value = numberOf(text);
    if (!value || !(*value >= number.min && *value <= number.max)) return false;
    number.member.in(settings) = *value;
    return true;
  }
  bool operator()(const SettingWords& setting) const {
    const auto found = std::find_if(setting.words.begin(), setting.words.end(),
                                    [this](const SettingWord& word) { return word.word == text; });
    if (found == setting.words.end()) return false;
    setting.choose(settings, static_cast<std::size_t>(found - setting.words.begin()));
    return true;
  }
  bool operator()(QualityPart part) const { return parse(text, part, settings.quality); }
  bool operator()(SettingMember<UntoldElements> untold) const { return parse(text, untold.in(settings)); }
  bool operator()(const SettingText& setting) const {
    if (text != kNoText && !setting.isValid(text)) return false;
    setting.member.in(settings) = text == kNoText ? "" : text;
    return true;
  }
};

// The value of a line; nothing if there is no line.
struct SettingWriter {
  using Text = std::optional<std::string>;
  const Settings& settings;

  Text operator()(const SettingFlag& flag) const { return flag.member.of(settings) ? "on" : "off"; }
  Text operator()(const SettingNumber& number) const { return textOf(number.member.of(settings)); }
  Text operator()(const SettingWords& setting) const {
    return std::string(setting.words[setting.index(settings)].word);
  }
  Text operator()(QualityPart part) const { return platon::textOf(part, settings.quality); }
  Text operator()(SettingMember<UntoldElements> untold) const { return platon::textOf(untold.of(settings)); }
  Text operator()(const SettingText& setting) const {
    const std::string& text = setting.member.of(settings);
    return text.empty() ? std::string(kNoText) : text;
  }
};

}  // namespace

std::span<const Setting> settingTable() { return kSettings; }

std::string allowedValues(const Setting& setting) { return std::visit(AllowedValues(), setting.value); }

bool readSetting(const Setting& setting, std::string_view value, Settings& settings) {
  return std::visit(SettingReader{value, settings}, setting.value);
}

std::string settingLines(const Settings& settings) {
  std::string text;
  for (const Setting* setting : kLines) {
    const std::optional<std::string> value = std::visit(SettingWriter{settings}, setting->value);
    if (value) text += std::string(setting->name) + " " + *value + "\n";
  }
  return text;
}

}  // namespace platon
