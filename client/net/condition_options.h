#pragma once

#include "client/net/network_conditions.h"

namespace CLI {
class App;
}

namespace platon {

/// Describes the options of a simulated line, in a group of their own: --loss --burst-loss --burst-length --delay
/// --jitter --duplicate --reorder --rate --corrupt. Parsing refuses what is out of range, and a --burst-length without
/// --burst-loss, and else fills `line`, which must last until then.
void describeConditionOptions(CLI::App& app, LinkQuality& line);

/// Where `--help` lists them.
inline constexpr const char* kConditionGroup = "Simulated line";

}  // namespace platon
