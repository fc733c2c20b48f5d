#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "levels/solve/recorded_way.h"
#include "platon/game/level.h"

namespace platon {

/// A level that is shipped, and the way to its goal that tests/levels/record.sh has recorded.
class ShippedLevel {
 public:
  /// Loads the level file. Throws std::runtime_error if it is invalid or one of both is missing.
  explicit ShippedLevel(const std::string& file);

  /// File name without extension.
  const std::string& name() const { return name_; }
  const std::shared_ptr<const Level>& level() const { return level_; }
  /// Bytes of the recording.
  const std::vector<std::uint8_t>& recording() const { return recording_; }
  /// Whether the recording is complete, and of the present text of the level and the present rules.
  bool isRecordedAsItIs() const { return way_.level && way_.level->hash == level_->hash; }
  /// The recorded inputs.
  const Solution& way() const { return way_.inputs; }

 private:
  std::string name_;
  std::shared_ptr<const Level> level_;
  std::vector<std::uint8_t> recording_;
  RecordedWay way_;
};

/// The level with each line of its text replaced by what change(number, line) returns. Null if it is invalid then.
std::shared_ptr<const Level> changed(const Level& level,
                                     const std::function<std::string(int, const std::string&)>& change);

/// Name of a level file for a test: without folder and extension.
std::string shippedName(const std::string& file);

}  // namespace platon
