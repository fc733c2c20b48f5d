#include "client/ui/controls/bindings.h"

#include <array>
#include <cstddef>
#include <utility>

#include "client/ui/controls/key_names.h"

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
                                                                {"say", "Talk to all players"},
                                                                {"wave", "Wave"},
                                                                {"laugh", "Laugh"},
                                                                {"here", "Call: here!"},
                                                                {"thanks", "Say thanks"}}};

bool has(const ControlKeys& keys, Key key) { return keys.first == key || keys.second == key || keys.pad == key; }

}  // namespace

std::string_view nameOf(Control control) { return kControlNames[static_cast<std::size_t>(control)].shown; }

std::string_view wordOf(Control control) { return kControlNames[static_cast<std::size_t>(control)].word; }

std::optional<Control> controlNamed(std::string_view word) {
  for (std::size_t i = 0; i < kControlCount; ++i) {
    if (kControlNames[i].word == word) return static_cast<Control>(i);
  }
  return std::nullopt;
}

Bindings::Bindings(KeySet set) {
  if (set == KeySet::kFirst) {
    keys_ = {{{Key::kArrowLeft, Key::kA, Key::kPadLeft},
              {Key::kArrowRight, Key::kD, Key::kPadRight},
              {Key::kArrowUp, Key::kW, {}},  // not the gamepad's: pushing the stick up must not jump
              {Key::kArrowDown, Key::kS, Key::kPadDown},
              {Key::kSpace, {}, Key::kPadA},
              {Key::kShift, {}, Key::kPadLeftBumper},
              {Key::kR, {}, Key::kPadBack},
              {Key::kV, {}, Key::kPadY},
              {Key::kTab, {}, {}},  // the right stick looks round
              {Key::kE, {}, Key::kPadRightBumper},
              {Key::kT, {}, Key::kPadX},
              {Key::kDigit1, {}, {}},
              {Key::kDigit2, {}, {}},
              {Key::kDigit3, {}, {}},
              {Key::kDigit4, {}, {}}}};
  } else {
    at(Control::kLeft).first = Key::kArrowLeft;
    at(Control::kRight).first = Key::kArrowRight;
    at(Control::kUp).first = Key::kArrowUp;  // jumps
    at(Control::kDown).first = Key::kArrowDown;
    at(Control::kSlow).first = Key::kPeriod;
    at(Control::kRestart).first = Key::kSlash;
  }
}

Bindings Bindings::without(const Bindings& other) const {
  Bindings rest = *this;
  for (std::size_t i = 0; i < kControlCount; ++i) {
    const ControlKeys& keys = keys_[i];
    for (const std::optional<Key>& key : {keys.first, keys.second})
      if (key && other.controlOf(*key)) rest.remove(static_cast<Control>(i), *key);
  }
  return rest;
}

std::optional<Control> Bindings::controlOf(Key key) const {
  for (std::size_t i = 0; i < kControlCount; ++i) {
    if (has(keys_[i], key)) return static_cast<Control>(i);
  }
  return std::nullopt;
}

bool Bindings::isAny(Control control, const std::bitset<kKeyCount>& down) const {
  const auto isDown = [&down](std::optional<Key> key) { return key && down[static_cast<std::size_t>(*key)]; };
  const ControlKeys& keys = keysOf(control);
  return isDown(keys.first) || isDown(keys.second) || isDown(keys.pad);
}

std::optional<Control> Bindings::bind(Control control, Key key) {
  const std::optional<Control> owner = controlOf(key);
  if (owner) remove(*owner, key);
  ControlKeys& keys = at(control);
  if (isOfGamepad(key))
    keys.pad = key;
  else
    keys.second = std::exchange(keys.first, key);
  return owner == control ? std::nullopt : owner;
}

void Bindings::remove(Control control, Key key) {
  ControlKeys& keys = at(control);
  if (keys.pad == key) keys.pad.reset();
  if (keys.first == key) keys.first = std::exchange(keys.second, std::nullopt);
  if (keys.second == key) keys.second.reset();
}

namespace {

using Keys = std::array<std::optional<Key>, 3>;

Keys inOrder(const ControlKeys& keys) { return {keys.first, keys.second, keys.pad}; }

// The place that a key of a line takes; null if there is none left.
std::optional<Key>* placeFor(Key key, ControlKeys& keys) {
  std::optional<Key>* const place = isOfGamepad(key) ? &keys.pad : keys.first ? &keys.second : &keys.first;
  return place->has_value() || keys.first == key ? nullptr : place;
}

// Nothing if the words are not the keys of a control.
std::optional<ControlKeys> keysOf(std::span<const std::string> words) {
  ControlKeys keys;
  if (words.size() == 1 && words.front() == "none") return keys;
  if (words.empty()) return std::nullopt;
  for (const std::string& word : words) {
    const std::optional<Key> key = keyNamed(word);
    std::optional<Key>* const place = key ? placeFor(*key, keys) : nullptr;
    if (place == nullptr) return std::nullopt;
    *place = key;
  }
  return keys;
}

}  // namespace

std::string textOf(const Bindings& bindings, KeySet set) {
  std::string text;
  for (std::size_t i = 0; i < kControlCount; ++i) {
    const auto control = static_cast<Control>(i);
    if (!isOfSet(control, set)) continue;
    std::string words;
    for (const std::optional<Key>& key : inOrder(bindings.keysOf(control))) {
      if (key) words += " " + std::string(wordOf(*key));
    }
    text += std::string(wordOf(set)) + " " + std::string(wordOf(control)) + (words.empty() ? " none" : words) + "\n";
  }
  return text;
}

std::string BindingsReader::read(Control control, std::span<const std::string> words) {
  const std::optional<ControlKeys> keys = keysOf(words);
  if (!isOfSet(control, set_)) return "belongs to the first player: remove the line";
  if (set_ == KeySet::kSecond && (!keys || keys->pad)) return "must be none, or up to two keys, such as: arrow-left j";
  if (!keys) return "must be none, or up to two keys and a button of the gamepad, such as: space j pad-a";
  if (std::string fault = faultOf(control, *keys); !fault.empty()) return fault;
  bindings_.clear(control);
  for (const std::optional<Key>& key : {keys->pad, keys->second, keys->first}) {
    if (key) bindings_.bind(control, *key);
  }
  read_.set(static_cast<std::size_t>(control));
  return {};
}

std::string BindingsReader::faultOf(Control control, const ControlKeys& keys) const {
  for (const std::optional<Key>& key : inOrder(keys)) {
    const std::optional<Control> owner = key ? bindings_.controlOf(*key) : std::nullopt;
    if (!owner || owner == control || !read_[static_cast<std::size_t>(*owner)]) continue;
    return "must not use " + std::string(wordOf(*key)) + ", which " + std::string(wordOf(*owner)) + " already uses";
  }
  return {};
}

}  // namespace platon
