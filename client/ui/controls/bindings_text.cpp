#include "client/ui/controls/bindings_text.h"

#include <array>
#include <cstddef>
#include <optional>

#include "client/ui/controls/key_names.h"

namespace platon {
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

std::string textOf(const Bindings& bindings) {
  std::string text;
  for (std::size_t i = 0; i < kControlCount; ++i) {
    const auto control = static_cast<Control>(i);
    std::string words;
    for (const std::optional<Key>& key : inOrder(bindings.keysOf(control))) {
      if (key) words += " " + std::string(wordOf(*key));
    }
    text += "key " + std::string(wordOf(control)) + (words.empty() ? " none" : words) + "\n";
  }
  return text;
}

std::string BindingsReader::read(Control control, std::span<const std::string> words) {
  const std::optional<ControlKeys> keys = keysOf(words);
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
