#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "client/session/known_levels.h"
#include "protocol/transport/server_address.h"

namespace platon {

/// Levels that servers have sent, on disk, so that none is sent twice. Each server has a folder of its own, because a
/// client tells a server which levels it has: otherwise, servers could recognise a player by the levels of others. The
/// name of a file is the hash of its text, which is checked when the file is read. A cache that cannot be read or
/// written stores nothing.
class LevelCache : public LevelStore {
 public:
  /// Bounds of all servers together; the levels that were used longest ago are removed.
  static constexpr std::size_t kMaxLevels = 256;
  static constexpr std::uint64_t kMaxBytes = std::uint64_t{64} << 20;

  /// Levels of a server below `folder`; an empty path: none.
  LevelCache(const std::filesystem::path& folder, const ServerAddress& server);

  std::vector<std::uint64_t> newest(std::size_t count) const override;
  std::shared_ptr<const Level> load(std::uint64_t hash) override;
  void keep(const Level& level) override;

 private:
  void limit() const;

  std::filesystem::path all_;     // empty: no cache
  std::filesystem::path folder_;  // of the server
};

}  // namespace platon
