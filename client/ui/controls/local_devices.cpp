#include "client/ui/controls/local_devices.h"

#include <algorithm>

namespace platon {

std::optional<std::uint32_t> LocalDevices::find(int device) const {
  for (std::uint32_t local = 1; local < devices_.size(); ++local)
    if (devices_[local] == device) return local;
  return std::nullopt;
}

std::uint32_t LocalDevices::ownerOf(const KeyEvent& event, const Bindings& secondKeys) const {
  if (isOfGamepad(event.key)) return find(event.pad).value_or(0);
  return secondKeys.controlOf(event.key) ? find(kKeyboard).value_or(0) : 0;
}

DeviceChange LocalDevices::toggle(const KeyEvent& event) {
  const int device = isOfGamepad(event.key) ? event.pad : kKeyboard;
  if (const std::optional<std::uint32_t> local = find(device)) {
    devices_[*local].reset();
    return DeviceChange::kLeft;
  }
  if (const std::optional<std::uint32_t> lost = find(kLost)) {
    devices_[*lost] = device;
    return DeviceChange::kReturned;
  }
  const auto free = std::find(devices_.begin() + 1, devices_.end(), std::nullopt);
  if (free == devices_.end()) return DeviceChange::kNone;
  *free = device;
  return DeviceChange::kJoined;
}

bool LocalDevices::lose(int pad) {
  const std::optional<std::uint32_t> local = find(pad);
  if (local) devices_[*local] = kLost;
  return local.has_value();
}

}  // namespace platon
