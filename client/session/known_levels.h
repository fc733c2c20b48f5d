#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "client/session/work_limit.h"
#include "platon/game/level.h"
#include "protocol/to_client.h"
#include "protocol/transfer.h"

namespace platon {

/// Levels of a server that outlive the sessions with it. A session asks it before it requests a level.
class LevelStore {
 public:
  virtual ~LevelStore() = default;
  /// Hashes of the levels that were used last, at most `count`. A level among them may turn out to be lost.
  virtual std::vector<std::uint64_t> newest(std::size_t count) const = 0;
  /// The level with this hash; null if it is not stored. Its text has been checked against the hash.
  virtual std::shared_ptr<const Level> load(std::uint64_t hash) = 0;
  /// Stores a level. It may be lost again.
  virtual void keep(const Level& level) = 0;
};

/// The levels that a session need not request, and the one that it receives: those of earlier sessions with the server,
/// those of a store, and those that the server has sent in chunks, one level at a time. What it costs is added to a
/// WorkLimit.
class KnownLevels {
 public:
  /// Largest number of levels that are requested without receiving one.
  static constexpr std::uint32_t kMaxUnansweredRequests = 16;

  /// `levels`: of earlier sessions, at most kMaxLevelsKnown, newest last. `store`: null if there is none.
  KnownLevels(std::vector<std::shared_ptr<const Level>> levels, std::shared_ptr<LevelStore> store);

  /// Hashes for Hello, at most kMaxLevelsKnown.
  const std::vector<std::uint64_t>& announced() const { return announced_; }
  /// At most kMaxLevelsKnown, newest last.
  const std::vector<std::shared_ptr<const Level>>& levels() const { return levels_; }
  const std::shared_ptr<LevelStore>& store() const { return store_; }

  /// The level with this hash; null if it must come from the server.
  std::shared_ptr<const Level> find(std::uint64_t hash, WorkLimit& work);
  /// Call with the level of Welcome: the server sends it without a request, unless Hello has announced it.
  void expectFirst(std::uint64_t hash, WorkLimit& work);
  /// Whether the level must be requested: it is neither known nor being received.
  bool lacks(std::uint64_t hash, WorkLimit& work) { return requested_ != hash && !find(hash, work); }
  /// Notes that the level is requested, which ends the reception of another one. False, without effect, if too many
  /// requests are unanswered.
  bool request(std::uint64_t hash);

  enum class Receipt { kNone, kLevel, kInvalid };
  /// Takes a chunk. kNone until it completes the requested level, and for any other level.
  Receipt receive(const LevelChunk& message, WorkLimit& work);

 private:
  void remember(std::shared_ptr<const Level> level);

  std::vector<std::shared_ptr<const Level>> levels_;
  std::shared_ptr<LevelStore> store_;
  std::vector<std::uint64_t> announced_;
  std::optional<std::uint64_t> requested_;  // hash of the level being received
  std::uint32_t unanswered_ = 0;            // requests since the last level
  Assembly text_;
};

}  // namespace platon
