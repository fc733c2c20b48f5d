#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "client/replay/run_store.h"
#include "platon/game/level.h"

namespace platon {

/// Most recordings of others that are looked at.
inline constexpr std::size_t kMaxListedOthers = 64;

/// A recording as a list shows it, whoever has made it: its time is known if it is a run that can be played.
ListedRun describeRecording(const std::filesystem::path& file);

/// The runs of a store, newest first, then the recordings in the folder of ghosts, newest first.
std::vector<ListedRun> listRecordings(const RunStore& own, const std::filesystem::path& ghosts);

}  // namespace platon
