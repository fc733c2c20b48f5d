#include "client/ui/controls/local_devices.h"

#include <algorithm>

namespace platon {

std::optional<std::uint32_t> LocalDevices::find(int id) const {
  for (std::uint32_t local = 1; local < devices_.size(); ++local)
    if (devices_[local] && devices_[local]->id == id) return local;
  return std::nullopt;
}

std::uint32_t LocalDevices::ownerOf(const KeyEvent& event, const Bindings& secondKeys) const {
  if (isOfGamepad(event.key)) return find(event.pad).value_or(0);
  return secondKeys.controlOf(event.key) ? find(kKeyboard).value_or(0) : 0;
}

DeviceChange LocalDevices::toggle(const KeyEvent& event) {
  const int id = isOfGamepad(event.key) ? event.pad : kKeyboard;
  if (const std::optional<std::uint32_t> local = find(id)) {
    devices_[*local].reset();
    return DeviceChange::kLeft;
  }
  const auto lost =
      std::find_if(devices_.begin(), devices_.end(), [](const auto& device) { return device && device->isLost; });
  if (lost != devices_.end()) {
    *lost = Device{id};
    return DeviceChange::kReturned;
  }
  const auto free =
      std::find_if(devices_.begin() + 1, devices_.end(), [](const auto& device) { return !device.has_value(); });
  if (free == devices_.end()) return DeviceChange::kNone;
  *free = Device{id};
  return DeviceChange::kJoined;
}

void LocalDevices::observe(const KeyEvent& event) {
  const std::optional<std::uint32_t> local = isOfGamepad(event.key) ? find(event.pad) : std::nullopt;
  if (local && event.kind == KeyEvent::Kind::kPress) devices_[*local]->isLost = false;
}

bool LocalDevices::lose(int pad) {
  const std::optional<std::uint32_t> local = find(pad);
  if (local) devices_[*local]->isLost = true;
  return local.has_value();
}

}  // namespace platon
