#include "client/editor/editor_panel.h"

#include <array>
#include <cstddef>
#include <cstdio>

#include "client/editor/level_document.h"
#include "client/ui/font.h"
#include "client/ui/overlay.h"
#include "protocol/texts.h"

namespace platon {
namespace {

using namespace overlay_colours;

constexpr float kMargin = 16;
constexpr float kPanelWidth = 250;
constexpr float kSize = kSmallestText;
constexpr std::size_t kMaxLines = 5;  // of the report

constexpr std::array<std::array<const char*, 2>, 21> kHelp{{{"S D E W T G P", "tools: select, draw … play"},
                                                            {"left button", "use the tool"},
                                                            {"right button, arrows", "turn the solid"},
                                                            {"wheel, Page Up/Down", "zoom"},
                                                            {"C", "show the face upright"},
                                                            {"Alt", "no snapping"},
                                                            {"Shift", "snap the direction"},
                                                            {"+  -", "grid"},
                                                            {"X, Shift+X", "next, previous word"},
                                                            {"0 … 9", "number; for up: the top edge"},
                                                            {",", "then digits: how long timed is open"},
                                                            {"F", "flip the direction"},
                                                            {"Delete", "erase the selected segment"},
                                                            {"Ctrl+Z, Ctrl+Y", "undo, redo"},
                                                            {"Ctrl+S", "save"},
                                                            {"H", "show where the ball can get"},
                                                            {"P, click", "play from there"},
                                                            {"Esc", "stop playing; open the menu"},
                                                            {"F1", "help"},
                                                            {"F11", "full screen"},
                                                            {"tool T, then F", "turn the start"}}};

glm::vec4 colourOf(LevelReport::Way way) {
  switch (way) {
    case LevelReport::Way::kFound:
      return kGood;
    case LevelReport::Way::kSearching:
      return kSoft;
    default:
      return kWarning;
  }
}

const char* signOf(LevelReport::Way way) {
  switch (way) {
    case LevelReport::Way::kFound:
      return "✓ ";
    case LevelReport::Way::kSearching:
      return "… ";
    default:
      return "✗ ";
  }
}

std::string secondsText(std::uint32_t ticks) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2f s", ticks / 60.0);
  return text.data();
}

void addTools(OverlayWriter& writer, const EditorStatus& status, glm::vec2 place) {
  for (const EditToolFacts& facts : kEditTools) {
    const bool chosen = facts.tool == status.tool;
    if (chosen) {
      writer.panel({kMargin + 6, place.y - 16}, {kMargin + kPanelWidth - 6, place.y + 6}, 7, kSelected);
    }
    writer.left(facts.letter, place, kSize, chosen ? kGold : kSoft);
    writer.left(facts.name, place + glm::vec2(26, 0), kSize, chosen ? kBright : kSoft);
    place.y += 24;
  }
}

void addHead(OverlayWriter& writer, const EditorStatus& status) {
  const float height = 108 + 24.0F * kEditTools.size();
  writer.panel({kMargin, kMargin}, {kMargin + kPanelWidth, kMargin + height}, 12, kPanel);
  writer.left(status.file + (status.unsaved ? " *" : ""), {kMargin + 14, kMargin + 26}, 16,
              status.unsaved ? kGold : kBright);
  writer.left(status.title, {kMargin + 14, kMargin + 46}, kSize, kSoft);
  addTools(writer, status, {kMargin + 14, kMargin + 74});
  const float below = kMargin + 74 + 24.0F * kEditTools.size();
  writer.left(nameOf(status.word) + " · grid " + coordinateText(status.grid), {kMargin + 14, below}, kSize, kBright);
  writer.left(status.place.empty() ? "F1: help" : status.place, {kMargin + 14, below + 22}, kSize, kSoft);
}

void addReport(OverlayWriter& writer, const EditorStatus& status, const Font& font, float width) {
  std::vector<std::string> lines;
  for (const std::string& line : linesOf(status.report)) {
    for (const std::string& part : wrapText(line, font, 272 / kSize)) lines.push_back(part);
  }
  const float left = width - kMargin - 300;
  const float height = 22.0F * static_cast<float>(lines.size()) + 18;
  writer.panel({left, kMargin}, {width - kMargin, kMargin + height}, 12, kPanel);
  glm::vec2 place(left + 14, kMargin + 25);
  for (std::size_t i = 0; i < lines.size(); ++i, place.y += 22) {
    const std::string sign = i == 0 ? signOf(status.report.way) : "";
    writer.left(sign + lines[i], place, kSize, i == 0 ? colourOf(status.report.way) : kSoft);
  }
}

void addHelp(OverlayWriter& writer, glm::vec2 screen) {
  const float height = 21.0F * kHelp.size() + 18;
  const glm::vec2 low(screen.x - kMargin - 420, screen.y - kMargin - height);
  writer.panel(low, screen - kMargin, 12, {0.04F, 0.05F, 0.09F, 0.88F});
  glm::vec2 place = low + glm::vec2(14, 25);
  for (const auto& [keys, meaning] : kHelp) {
    writer.left(keys, place, kSize, kBright);
    writer.left(meaning, place + glm::vec2(176, 0), kSize, kSoft);
    place.y += 21;
  }
}

// At the lower edge, errors above other messages.
void addMessages(OverlayWriter& writer, const EditorStatus& status, const Font& font, glm::vec2 screen) {
  glm::vec2 middle(screen.x / 2, screen.y - 34);
  const auto add = [&](const std::string& text, glm::vec4 colour) {
    if (text.empty()) return;
    middle.y = writer.pill(wrapText(text, font, (screen.x - 2 * kPanelWidth) / kSize), middle, kSize, colour) - 22;
  };
  add(status.message, kSoft);
  add(status.error, kWarning);
  if (status.playing)
    add(std::string(status.arrived ? "✓ Goal!" : "Playing") + " · R: try again from here · Esc: back to editing",
        status.arrived ? kGold : kBright);
}

std::vector<std::string> linesOfWay(const LevelReport& report) {
  const SolutionFacts& facts = report.facts;
  switch (report.way) {
    case LevelReport::Way::kSearching:
      return {report.reached ? "searching for a way to the goal" : "finding where the ball can get"};
    case LevelReport::Way::kImpossible:
      return {"the goal cannot be reached", "proved: the ball cannot leave the blue dots"};
    case LevelReport::Way::kNotFound:
      if (report.states >= LevelAnalysis::kMaxStates)
        return {"gave up searching for a way",
                "after " + std::to_string(report.states) + " states; closed rooms shorten the search"};
      return {"no way to the goal found", std::to_string(report.states) + " states searched; there may still be one"};
    case LevelReport::Way::kFound:
      break;
  }
  std::vector<std::string> lines{"solved in " + secondsText(facts.ticks)};
  lines.push_back(counted(facts.presses, "press") + ", " + counted(facts.crossings, "crossing") + ", " +
                  counted(facts.turns, "turn") + " of down");
  lines.push_back((facts.slack ? "tightest jump " + counted(static_cast<std::size_t>(*facts.slack), "tick")
                               : std::string("no jump")) +
                  ", difficulty " + std::to_string(difficultyOf(facts)));
  return lines;
}

}  // namespace

std::vector<std::string> linesOf(const LevelReport& report) {
  std::vector<std::string> lines = linesOfWay(report);
  if (report.level && report.level->players > 1)
    lines.push_back("for " + std::to_string(report.level->players) + " players; all must reach the goal");
  for (const Diagnostic& warning : report.warnings) {
    if (lines.size() == kMaxLines) break;
    lines.push_back("text line " + std::to_string(warning.line) + ": " + warning.message);
  }
  return lines;
}

std::string nameOf(const SegmentWord& word) {
  if (!word.kind) return "segment";
  std::string name(wordOf(*word.kind));
  for (std::size_t i = 0; i < word.count(); ++i) name += " " + std::to_string(word.numbers[i]);
  return name;
}

Overlay makeEditorPanel(const EditorStatus& status, const Font& font, glm::vec2 screen) {
  OverlayWriter writer(font);
  addHead(writer, status);
  addReport(writer, status, font, screen.x);
  if (status.help) addHelp(writer, screen);
  addMessages(writer, status, font, screen);
  return writer.take();
}

}  // namespace platon
