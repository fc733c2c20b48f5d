#include "client/menu/pages/controls_page.h"

#include <cstddef>

#include "client/ui/controls/key_names.h"

namespace platon {
namespace {

constexpr const char* kMenuKeys = "Menus always use the arrow keys, Enter and Esc.";

std::string quoted(Control control) { return "“" + std::string(nameOf(control)) + "”"; }

std::string allKeysOf(const Bindings& bindings, Control control) {
  const KeyHints hints(bindings);
  const std::string keys = hints.keys(control);
  const std::string pad = hints.pad(control);
  if (keys.empty() && pad.empty()) return "none";
  return keys.empty() || pad.empty() ? keys + pad : keys + ", " + pad;
}

// Whether the event answers what the page waits for: tilts of a stick also arrive as keys.
bool isAnswer(const KeyEvent& event) {
  return event.kind == KeyEvent::Kind::kPress && (!isOfGamepad(event.key) || canBeBound(event.key));
}

std::string bound(Bindings& bindings, Control control, Key key) {
  const std::optional<Control> owner = bindings.bind(control, key);
  const std::string name(shownNameOf(key));
  if (!owner) return quoted(control) + " has " + name + " now.";
  return quoted(control) + " has taken " + name + " from " + quoted(*owner) + ", which has " +
         allKeysOf(bindings, *owner) + " now.";
}

void take(const KeyEvent& event, Bindings& bindings, ControlsForm& form) {
  const Control control = *form.waiting;
  if (event.key == Key::kPadStart) {
    form = {};
  } else if (!isAnswer(event)) {
    return;
  } else if (event.key == Key::kEscape) {
    form = {};
  } else if (event.key == Key::kDelete || event.key == Key::kBackspace) {
    bindings.clear(control);
    form = {{}, quoted(control) + " has no key or button now."};
  } else if (!canBeBound(event.key)) {
    form.told = std::string(shownNameOf(event.key)) + " cannot be chosen.";
  } else {
    form = {{}, bound(bindings, control, event.key)};
  }
}

std::string noteOf(const ControlsForm& form) {
  if (!form.waiting) return form.told.empty() ? kMenuKeys : form.told;
  const std::string asks = "Press the key or button for " + quoted(*form.waiting) + ". Delete: clear. Esc: cancel.";
  return form.told.empty() ? asks : form.told + " " + asks;
}

}  // namespace

MenuPage controlsPage(Bindings& bindings, ControlsForm& form) {
  MenuPage page{"Keys and buttons", {noteOf(form)}};
  for (std::size_t i = 0; i < kControlCount; ++i) {
    const auto control = static_cast<Control>(i);
    page.items.push_back({.name = std::string(nameOf(control)),
                          .value = form.waiting == control ? "…" : allKeysOf(bindings, control),
                          .choose = [control, &form] {
                            form = {control, ""};
                          }});
  }
  page.items.push_back({.name = "Reset to the defaults", .choose = [&bindings, &form] {
                          bindings = Bindings();
                          form = {{}, "All keys and buttons have their defaults."};
                        }});
  if (form.waiting) page.takeKey = [&bindings, &form](const KeyEvent& event) { take(event, bindings, form); };
  return page;
}

}  // namespace platon
