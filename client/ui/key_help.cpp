#include "client/ui/key_help.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "client/ui/text_scale.h"

namespace platon {
namespace {

using namespace overlay_colours;

constexpr float kHelpMargin = 16;
constexpr float kHelpSize = kSmallestText;
constexpr float kHelpRowHeight = 22;
constexpr float kHelpGap = 18;

using Row = std::array<std::string, 3>;  // keys, button of a gamepad, meaning

// `brief`: one key or button of each control.
std::vector<Row> rowsOf(const KeyHints& hints, bool brief) {
  const auto keys = [&](Control control) { return brief ? hints.of(control) : hints.keys(control); };
  const auto pad = [brief](const std::string& button) { return brief ? std::string() : button; };
  const auto row = [&](Control control, const char* meaning) {
    return Row{keys(control), pad(hints.pad(control)), meaning};
  };
  const std::string run = brief ? hints.of(Control::kLeft) + " " + hints.of(Control::kRight) : hints.run();
  return {{run, pad("stick: 3 speeds"), "run"},
          row(Control::kSlow, "run slower"),
          row(Control::kJump, "jump; hold to jump higher"),
          row(Control::kUp, "jump, or move up the screen"),
          row(Control::kDown, "fall faster"),
          {keys(Control::kLook) + " and arrows", pad("right stick"), "look round the solid"},
          row(Control::kRestart, "back to the start"),
          row(Control::kVote, "next level, or a vote for it"),
          row(Control::kWatch, "after the goal: watch others"),
          row(Control::kSay, "talk to all players"),
          {"F1", "", "help"},
          {"F3", "", "connection graph"},
          {"F11", "", "full screen"},
          {"Esc", pad("Start"), "pause, settings, leave"}};
}

}  // namespace

void addHelp(OverlayWriter& writer, const KeyHints& keys, bool brief) {
  const std::vector<Row> rows = rowsOf(keys, brief);
  std::array<float, 3> widths{};
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (!row[i].empty()) widths[i] = std::max(widths[i], writer.width(row[i], kHelpSize) + kHelpGap);
    }
  }
  const glm::vec2 size(widths[0] + widths[1] + widths[2] + kHelpGap,
                       kHelpRowHeight * static_cast<float>(rows.size()) + 20);
  const glm::vec2 low(kHelpMargin, Overlay::kHeight - kHelpMargin - size.y);
  writer.panel(low, low + size, 12, kPanel);
  glm::vec2 place = low + glm::vec2(kHelpGap, 27);
  for (const auto& [key, pad, meaning] : rows) {
    writer.left(key, place, kHelpSize, kBright);
    writer.left(pad, place + glm::vec2(widths[0], 0), kHelpSize, kBright);
    writer.left(meaning, place + glm::vec2(widths[0] + widths[1], 0), kHelpSize, kSoft);
    place.y += kHelpRowHeight;
  }
}

}  // namespace platon
