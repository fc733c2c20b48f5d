#pragma once

#include "client/net/network_conditions.h"
#include "protocol/program_options.h"

namespace platon {

/// Adds the options for simulated network conditions, in a group of their own: --loss --burst-loss --burst-length
/// --delay --jitter --duplicate --reorder --rate --corrupt. Reading writes the values to `quality`, and refuses values
/// out of range and --burst-length without --burst-loss.
void addConditionOptions(ProgramOptions& program, LinkQuality& quality);

}  // namespace platon
