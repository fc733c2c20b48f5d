#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <vector>

#include "platon/physics/map_part.h"
#include "platon/physics/world.h"
#include "shared/physics/step/leg.h"
#include "shared/physics/step/mover.h"
#include "shared/physics/step/step_contacts.h"
#include "shared/physics/step/step_events.h"
#include "tests/shared/physics/maps.h"
#include "tests/shared/physics/recorded_rules.h"
#include "tests/shared/physics/shapes.h"

namespace platon {

/// The parts of a step of entity 0.
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
  /// Starts a step of the entity in world_.
  void start(StepObserver* observer = nullptr) {
    state_ = world_.entities()[0];
    instances_.load(world_.geometry(), shapes_, world_.shapeOf(0), state_, world_.instancesOf(0));
    collider_.begin(rules_, Entity(world_, 0), instances_, regions_, work_);
    mover_.emplace(state_, instances_, collider_, contacts_, Mover::Watch{observer, 0, views_});
  }
  Mover& mover() { return *mover_; }

  World world_;
  RecordedRules rules_;
  StepEvents events_;
  EntityState state_;
  ShapeCache shapes_;
  Instances instances_;
  std::vector<Region> regions_;
  Region::Work work_;
  Collider collider_;
  std::vector<StepContacts::Change> changes_;
  std::vector<InstanceView> views_;
  std::vector<Collider::WarpRef> refused_;
  StepContacts contacts_{{0, 0}, instances_, collider_, events_, changes_};

 private:
  std::optional<Mover> mover_;
};

}  // namespace platon
