#include "client/audio/element_cues.h"

#include <algorithm>
#include <optional>

#include "client/audio/hearing.h"
#include "levels/drawing/solid_frame.h"

namespace platon {
namespace {

// Whether the key is taken, the door open, or the plate pressed. A plate of which the key is taken keeps still.
bool isOn(const Game& game, const Element& element) {
  switch (element.kind) {
    case ElementKind::kKey:
      return game.isTaken(element);
    case ElementKind::kDoor:
      return (game.openDoors() & element.bit()) != 0;
    case ElementKind::kPlate:
      return (game.openDoors() & element.bit()) != 0 && !game.isTaken(element);
    case ElementKind::kOneway:
    case ElementKind::kUp:
    case ElementKind::kHazard:
    case ElementKind::kCheckpoint:
      return false;
  }
  return false;
}

// A key that is there again makes no sound.
std::optional<Sound> soundOf(ElementKind kind, bool on) {
  switch (kind) {
    case ElementKind::kKey:
      return on ? std::optional(Sound::kKey) : std::nullopt;
    case ElementKind::kDoor:
      return on ? Sound::kDoorOpens : Sound::kDoorCloses;
    case ElementKind::kPlate:
      return on ? Sound::kPlateDown : Sound::kPlateUp;
    case ElementKind::kOneway:
    case ElementKind::kUp:
    case ElementKind::kHazard:
    case ElementKind::kCheckpoint:
      return std::nullopt;
  }
  return std::nullopt;
}

glm::dvec3 placeInSpace(const SolidMesh& mesh, const Element& element) {
  return mesh.toWorld(static_cast<int>(element.face), toUnits(placeOf(element)));
}

}  // namespace

std::vector<Cue> ElementCues::observe(const Game& game, std::uint32_t ticks, const SolidMesh& mesh,
                                      const Pose& listener) {
  const std::vector<Element>& elements = game.level().elements;
  if (elements.empty() || (!before_.empty() && ticks <= newest_)) return {};
  std::vector<std::uint8_t> now;
  for (const Element& element : elements) now.push_back(isOn(game, element) ? 1 : 0);
  std::vector<Cue> loudest;
  std::vector<std::uint32_t> keys;  // of `loudest`: sound and number
  for (std::size_t i = 0; i < now.size() && !before_.empty(); ++i) {
    const std::optional<Sound> sound = now[i] != before_[i] ? soundOf(elements[i].kind, now[i] != 0) : std::nullopt;
    if (!sound) continue;
    const Heard heard = hear(listener, placeInSpace(mesh, elements[i]));
    const Cue cue{.sound = *sound, .gain = heard.gain, .pan = heard.pan};
    const std::uint32_t key = static_cast<std::uint32_t>(*sound) * kMaxDoorNumbers + elements[i].number;
    const auto known = std::find(keys.begin(), keys.end(), key);
    if (known != keys.end()) {
      Cue& other = loudest[static_cast<std::size_t>(known - keys.begin())];
      if (other.gain < cue.gain) other = cue;
    } else if (filter_.passes(key, ticks, kEventTicks)) {
      keys.push_back(key);
      loudest.push_back(cue);
    }
  }
  before_ = std::move(now);
  newest_ = ticks;
  return loudest;
}

}  // namespace platon
