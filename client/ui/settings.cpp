#include "client/ui/settings.h"

#include <array>
#include <charconv>
#include <cmath>
#include <sstream>

namespace platon {
namespace {

constexpr double kLeastTurnSpeed = 1;
constexpr double kMaxTurnSpeed = 30;
constexpr double kLeastZoom = 0.5;
constexpr double kMaxZoom = 2;

// Each reads one value; false when it is none.
bool read(std::string_view value, bool& flag) {
  if (value != "on" && value != "off") return false;
  flag = value == "on";
  return true;
}

bool read(std::string_view value, double& number, double least, double most) {
  double read = 0;
  const auto [end, fault] = std::from_chars(value.data(), value.data() + value.size(), read);
  if (fault != std::errc() || end != value.data() + value.size()) return false;
  if (!(read >= least && read <= most)) return false;
  number = read;
  return true;
}

bool read(std::string_view value, ControlFrame& frame) {
  if (value != "player" && value != "screen") return false;
  frame = value == "screen" ? ControlFrame::kScreen : ControlFrame::kPlayer;
  return true;
}

// What is wrong with it; empty when nothing is.
std::string readLine(std::string_view name, std::string_view value, Settings& settings) {
  if (name == "turn-speed") {
    return read(value, settings.comfort.turnSpeed, kLeastTurnSpeed, kMaxTurnSpeed)
               ? ""
               : "turn-speed is a number from 1 to 30";
  }
  if (name == "zoom") return read(value, settings.zoom, kLeastZoom, kMaxZoom) ? "" : "zoom is a number from 0.5 to 2";
  if (name == "controls") return read(value, settings.controls) ? "" : "controls is player or screen";
  const std::array<std::pair<std::string_view, bool*>, 4> flags{{{"instant-cut", &settings.comfort.instantCut},
                                                                 {"reduced-motion", &settings.comfort.reducedMotion},
                                                                 {"fullscreen", &settings.fullscreen},
                                                                 {"net-graph", &settings.netGraph}}};
  for (const auto& [flag, place] : flags) {
    if (name == flag) return read(value, *place) ? "" : std::string(name) + " is on or off";
  }
  return "there is no setting '" + std::string(name) + "'";
}

const char* onOff(bool flag) { return flag ? "on" : "off"; }

}  // namespace

std::string Settings::text() const {
  std::ostringstream out;
  out << "turn-speed " << comfort.turnSpeed << "\ninstant-cut " << onOff(comfort.instantCut) << "\nreduced-motion "
      << onOff(comfort.reducedMotion) << "\ncontrols " << (controls == ControlFrame::kScreen ? "screen" : "player")
      << "\nzoom " << zoom << "\nfullscreen " << onOff(fullscreen) << "\nnet-graph " << onOff(netGraph) << "\n";
  return out.str();
}

SettingsResult parseSettings(std::string_view text) {
  SettingsResult result;
  std::istringstream lines{std::string(text)};
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::istringstream words(line);
    std::string name;
    std::string value;
    if (!(words >> name)) continue;
    words >> value;
    std::string rest;
    const std::string fault = words >> rest ? "one value is enough" : readLine(name, value, result.settings);
    if (!fault.empty()) {
      result.error = "line " + std::to_string(number) + ": " + fault;
      return result;
    }
  }
  return result;
}

}  // namespace platon
