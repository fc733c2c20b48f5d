#pragma once

#include "client/net/network_conditions.h"

namespace CLI {
class App;
}

namespace platon {

/// Adds the options for simulated network conditions, in a group of their own: --loss --burst-loss --burst-length
/// --delay --jitter --duplicate --reorder --rate --corrupt. Parsing writes the values to `quality`, which must outlive
/// `app`, and refuses values out of range and --burst-length without --burst-loss.
void addConditionOptions(CLI::App& app, LinkQuality& quality);

}  // namespace platon
