#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "client/editor/edited_segment.h"
#include "levels/solve/solution.h"
#include "platon/game/diagnostics.h"
#include "platon/game/level.h"
#include "protocol/work/worker.h"

namespace platon {

/// What is known of a level.
struct LevelReport {
  /// The way to the goal.
  enum class Way : std::uint8_t {
    kSearching,
    kFound,
    kNotFound,   ///< the search has ended; there may be a way that it misses
    kImpossible  ///< proved: whatever is pressed, nobody touches the goal
  };

  std::shared_ptr<const Level> level;
  Way way = Way::kSearching;
  /// Places on a lattice where the centre of a ball may be at most; null until they are known.
  std::shared_ptr<const std::vector<FacePlace>> reached;
  SolutionFacts facts;                        ///< of kFound
  std::vector<std::vector<FacePlace>> paths;  ///< of kFound: of each player, every few ticks
  std::size_t states = 0;                     ///< states that were searched
  std::vector<Diagnostic> warnings;           ///< what the level probably does not mean
  bool finished = false;                      ///< nothing will be added
};

/// Analyses one level after another in a thread: first where a ball can be at most, then a way to the goal.
class LevelAnalysis {
 public:
  /// Most states of a search: they bound its memory to some hundred megabytes.
  static constexpr std::size_t kMaxStates = 1000000;

  /// Gives up the present level and begins with this one. Does not wait.
  void start(std::shared_ptr<const Level> level);
  /// Returns the newest report if there is one since the last call.
  std::optional<LevelReport> take();

 private:
  // Of one level. One that was given up has a report that nobody takes.
  struct Report {
    std::mutex mutex;
    std::optional<LevelReport> newest;  // not yet taken

    void set(const LevelReport& report);
  };

  static bool analyse(const std::shared_ptr<const Level>& level, Report& published, const std::function<bool()>& stop);
  static void search(LevelReport& report, const std::function<bool()>& stop);

  std::shared_ptr<Report> report_ = std::make_shared<Report>();
  Worker<bool> analysing_;
};

}  // namespace platon
