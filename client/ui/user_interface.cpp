#include "client/ui/user_interface.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace platon {

std::optional<Action> UserInterface::handle(const KeyEvent& event, bool menuOpen) {
  const std::uint32_t local = devices_.ownerOf(event, settings_.secondKeys);
  if (event.kind == KeyEvent::Kind::kPress && local == 0)
    padUsed_ = isOfGamepad(event.key) ? std::optional(event.pad) : std::nullopt;
  devices_.observe(event);
  observe(event);
  configure();
  const std::optional<Action> action = mappers_[local].handle(event, menuOpen);
  if (action == Action::kToggleHelp) helpShown_ = !helpShown_;
  if (action == Action::kToggleNetGraph) settings_.netGraph = !settings_.netGraph;
  if (action == Action::kToggleFullscreen) settings_.fullscreen = !settings_.fullscreen;
  if (action == Action::kJoin) join(event);
  return action;
}

void UserInterface::observe(const KeyEvent& event) {
  if (event.kind == KeyEvent::Kind::kRepeat || event.kind == KeyEvent::Kind::kCharacter) return;
  std::erase_if(down_, [&](const KeyEvent& down) { return down.key == event.key && down.pad == event.pad; });
  if (event.kind == KeyEvent::Kind::kPress) down_.push_back(event);
}

// The keys that change hands are let go; players whose keys stay theirs roll on.
void UserInterface::join(const KeyEvent& event) {
  const auto ownerOf = [this](const KeyEvent& key) { return devices_.ownerOf(key, settings_.secondKeys); };
  std::vector<std::uint32_t> owners;
  std::transform(down_.begin(), down_.end(), std::back_inserter(owners), ownerOf);
  deviceChange_ = devices_.toggle(event);
  for (std::size_t i = 0; i < down_.size(); ++i)
    if (ownerOf(down_[i]) != owners[i]) mappers_[owners[i]].handle({down_[i].key, KeyEvent::Kind::kRelease}, false);
  if (isOfGamepad(event.key) && padUsed_ == event.pad) padUsed_.reset();
}

void UserInterface::removeCompanion(std::uint32_t local) {
  devices_.remove(local);
  mappers_[local].release();
}

Bindings UserInterface::ownKeys() const {
  return devices_.sharesKeyboard() ? settings_.bindings.without(settings_.secondKeys) : settings_.bindings;
}

// Companions with a gamepad have the buttons of the first player.
Bindings UserInterface::companionKeys() const {
  Bindings keys = settings_.secondKeys;
  for (std::size_t i = 0; i < kControlCount; ++i) {
    const auto control = static_cast<Control>(i);
    const std::optional<Key> pad = settings_.bindings.keysOf(control).pad;
    if (pad && isOfSet(control, KeySet::kSecond)) keys.bind(control, *pad);
  }
  return keys;
}

void UserInterface::configure() {
  mappers_[0].configure(ownKeys(), settings_.toggled);
  const Bindings companion = companionKeys();
  for (std::size_t local = 1; local < mappers_.size(); ++local) mappers_[local].configure(companion, {});
}

HeldKeys UserInterface::takeHeld(bool menuOpen, std::uint32_t local) {
  configure();
  HeldKeys held = mappers_[local].takeHeld();
  if (menuOpen) return {};
  if (local == 0) held.restart = std::exchange(restart_, false) || held.restart;
  return held;
}

bool UserInterface::loseGamepad(int pad) {
  const bool isOwn = padUsed_ == pad;
  if (isOwn) padUsed_.reset();
  return devices_.lose(pad) || isOwn;
}

}  // namespace platon
