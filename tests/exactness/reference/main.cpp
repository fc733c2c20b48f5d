// platon-reference: prints the distance of the simulated body from the ideal one, for every scene of the reference.
#include <array>
#include <cstdio>
#include <cstring>
#include <exception>

#include "tests/exactness/reference/lattice_error.h"

namespace {

using platon::reference::LatticeError;

constexpr auto kResolutions = std::to_array<std::int64_t>({1 << 4, 1 << 6, 1 << 8, 1 << 10, 1 << 12, 1 << 14, 1 << 16});
constexpr auto kTicks = std::to_array<std::int64_t>({1, 60, 3600});

void print(const LatticeError& error, bool json, bool first) {
  const char* layout = json ? "{\"scene\":\"%s\",\"subunitsPerUnit\":%lld,\"ticks\":%lld,\"legs\":%lld,"
                              "\"errorSubunits\":%.3f,\"maxErrorSubunits\":%.3f,\"errorUnits\":%.6g}"
                            : "%-12s %6lld %6lld %7lld %10.2f %10.2f %12.3g\n";
  if (json && !first) std::printf(",\n");
  std::printf(layout, error.scene.c_str(), static_cast<long long>(error.subunitsPerUnit),
              static_cast<long long>(error.ticks), static_cast<long long>(error.legs), error.subunits,
              error.maxSubunits, error.units());
}

void printAll(bool json) {
  std::printf(json ? "{\"trajectories\":[" : "%-12s %6s %6s %7s %10s %10s %12s\n", "scene", "per u", "ticks", "legs",
              "subunits", "max", "units");
  bool first = true;
  for (const auto& [name, scene] : platon::reference::allScenes()) {
    for (const LatticeError& error : latticeErrors(name, scene, kResolutions, kTicks)) {
      print(error, json, first);
      first = false;
    }
  }
  if (json) std::printf("]}\n");
}

}  // namespace

int main(int count, char** arguments) {
  const bool json = count == 2 && std::strcmp(arguments[1], "--json") == 0;
  if (count != 1 && !json) {
    std::fprintf(stderr, "usage: platon-reference [--json]\n");
    return 2;
  }
  try {
    printAll(json);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
