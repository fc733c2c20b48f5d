#include "client/menu/pages/replays_page.h"

namespace platon {
namespace {

bool beginsGroup(std::span<const ReplayEntry> entries, std::size_t entry) {
  return entry == 0 || entries[entry].who.empty() != entries[entry - 1].who.empty();
}

void append(std::string& text, const std::string& part) {
  if (!part.empty()) text += (text.empty() ? "" : " · ") + part;
}

std::string factsOf(const ReplayEntry& entry) {
  std::string facts = entry.who;
  append(facts, timeText(entry));
  append(facts, entry.note.substr(0, entry.note.find_first_of(":;")));  // its page tells the rest
  append(facts, entry.date);
  return facts;
}

std::string sentenceOf(const ReplayEntry& entry) {
  std::string facts = entry.who.empty() ? "Your run" : "A recording of " + entry.who;
  if (!entry.time.empty()) facts += ": " + timeText(entry) + (entry.isBest ? ", your best" : "");
  return facts + ". " + entry.date;
}

}  // namespace

// As the list of levels has it.
std::string timeText(const ReplayEntry& entry) {
  if (entry.time.empty() || (!entry.medal && !entry.isBest)) return entry.time;
  return starsOf(entry.medal) + " " + entry.time;
}

MenuPage replaysPage(std::span<const ReplayEntry> entries, const std::function<void(std::size_t)>& choose,
                     const std::function<void()>& back) {
  MenuPage page{"Replays"};
  page.place = MenuPage::Place::kLeft;
  if (entries.empty()) {
    page.notes = {
        "Reach a goal, and your best run on its level appears here. Drop a recording on the window to watch it."};
    page.items = {{.name = "Back", .choose = back}};
    page.backMark = false;
    return page;
  }
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const ReplayEntry& entry = entries[i];
    const char* const group = entry.who.empty() ? "Your best runs" : "Runs of others";
    if (beginsGroup(entries, i)) page.items.push_back({MenuItem::Kind::kHeading, group});
    page.items.push_back({.name = entry.title, .value = factsOf(entry), .choose = [choose, i] { choose(i); }});
    if (entry.medal) page.items.back().valueColour = colourOf(*entry.medal);
  }
  return page;
}

std::size_t itemOfReplay(std::span<const ReplayEntry> entries, std::size_t entry) {
  std::size_t item = entry;
  for (std::size_t i = 0; i <= entry; ++i) item += beginsGroup(entries, i) ? 1 : 0;
  return item;
}

std::size_t replayOfItem(std::span<const ReplayEntry> entries, std::size_t item) {
  std::size_t entry = 0;
  while (entry + 1 < entries.size() && itemOfReplay(entries, entry) < item) ++entry;
  return entry;
}

MenuPage runPage(const ReplayEntry& entry, const std::string& file, const std::string& fault,
                 const RunChoices& choices) {
  MenuPage page{entry.title};
  page.place = MenuPage::Place::kLeft;
  page.warning = !fault.empty() || !entry.note.empty();
  // The path comes last: it may be longer than the page.
  if (!fault.empty()) {
    page.notes = {sentenceOf(entry), fault, file};
  } else if (const std::string& why = entry.note.empty() ? entry.noRun : entry.note; !why.empty()) {
    page.notes = {sentenceOf(entry), "It " + why + ".", file};
  } else {
    page.notes = {sentenceOf(entry), "To share it, send this file to a friend, who drops it on the window of the game.",
                  file};
  }
  const auto offer = [&page](const char* name, const std::function<void()>& choose) {
    if (choose) page.items.push_back({.name = name, .choose = choose});
  };
  offer("Watch", choices.watch);
  offer("Race against it", choices.race);
  offer("Keep it as a ghost", choices.keep);
  if (page.items.empty()) {
    offer("Back", choices.back);
    page.backMark = false;
  }
  return page;
}

}  // namespace platon
