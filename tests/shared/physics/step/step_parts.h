#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <vector>

#include "platon/physics/map_part.h"
#include "platon/physics/world.h"
#include "shared/physics/step/stages.h"
#include "shared/physics/step/step_events.h"
#include "shared/physics/step/step_state.h"
#include "tests/shared/physics/maps.h"
#include "tests/shared/physics/recorded_rules.h"
#include "tests/shared/physics/shapes.h"

namespace platon {

/// A step of entity 0, and what it works on.
class StepParts : public testing::Test {
 protected:
  /// A square of 20 by 20 at the origin of part 0, which has these segments.
  void build(const std::vector<Segment>& segments) {
    world_ = World();
    instances_.forget();  // of the world before
    regions_.clear();
    addPart(world_, 0, segments);
    Entity entity(world_, square(10));
    MapPart(world_, 0).insert(entity, {0, 0}, Angle());
    start();
  }
  /// A square of 200 by 200 at `at` in the left one of two strips (maps.h), whose other one has these segments.
  void buildStrips(Point at, const std::vector<Segment>& second = {}) {
    world_ = twoStrips({}, second);
    Entity entity(world_, square(100));
    MapPart(world_, 1).insert(entity, at, Angle());
    start();
  }
  /// Starts a step of the entity in world_.
  void start(StepObserver* observer = nullptr) {
    state_ = world_.entities()[0];
    instances_.load(world_.geometry(), shapes_, world_.shapeOf(0), state_, world_.instancesOf(0));
    begin(rules_, observer);
  }
  /// The same with other rules, from the present instances.
  void begin(Rules& rules, StepObserver* observer = nullptr) {
    collider_.begin(rules, Entity(world_, 0), instances_, regions_, work_);
    step_.emplace(StepState{.id = {0, 0},
                            .entity = state_,
                            .instances = instances_,
                            .collider = collider_,
                            .buffers = buffers_,
                            .events = events_,
                            .observer = observer,
                            .touched = touched_});
    step_->observe();
  }
  StepState& step() { return *step_; }

  World world_;
  RecordedRules rules_;
  StepEvents events_;
  EntityState state_;
  ShapeCache shapes_;
  Instances instances_;
  std::vector<Region> regions_;
  Region::Work work_;
  Collider collider_;
  StepBuffers buffers_;
  std::uint32_t touched_ = Collider::kNoSegment;

 private:
  std::optional<StepState> step_;
};

}  // namespace platon
