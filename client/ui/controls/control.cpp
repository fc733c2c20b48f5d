#include "client/ui/controls/control.h"

#include <array>

namespace platon {
namespace {

struct ControlName {
  std::string_view word;
  std::string_view shown;
};

// By Control.
constexpr std::array<ControlName, kControlCount> kControlNames{{{"left", "Run left"},
                                                                {"right", "Run right"},
                                                                {"up", "Up, or jump"},
                                                                {"down", "Down, or fall faster"},
                                                                {"jump", "Jump"},
                                                                {"slow", "Run slower"},
                                                                {"restart", "Back to the start"},
                                                                {"vote", "Next level, or vote"},
                                                                {"look", "Look round"},
                                                                {"watch", "Watch another player"},
                                                                {"say", "Talk to all players"}}};

}  // namespace

std::string_view nameOf(Control control) { return kControlNames[static_cast<std::size_t>(control)].shown; }

std::string_view wordOf(Control control) { return kControlNames[static_cast<std::size_t>(control)].word; }

std::optional<Control> controlNamed(std::string_view word) {
  for (std::size_t i = 0; i < kControlCount; ++i) {
    if (kControlNames[i].word == word) return static_cast<Control>(i);
  }
  return std::nullopt;
}

}  // namespace platon
