#include "client/menu/pages/run_page.h"

namespace platon {
namespace {

std::string sentenceOf(const ReplayEntry& entry) {
  std::string facts = entry.who.empty() ? "Your run" : "A recording of " + entry.who;
  if (!entry.time.empty()) facts += ": " + timeText(entry) + (entry.isBest ? ", your best" : "");
  return facts + ". " + entry.date;
}

}  // namespace

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
