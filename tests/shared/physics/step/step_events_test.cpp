#include "shared/physics/step/step_events.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>

#include "platon/physics/entity.h"
#include "platon/physics/world.h"
#include "tests/shared/physics/recorded_rules.h"
#include "tests/shared/physics/shapes.h"

namespace platon::step_events_test {
namespace {

using testing::ElementsAre;

TEST(StepEventsTest, AreDeliveredInTheirOrder) {
  World world;
  Entity entity(world, square(10));
  RecordedRules rules;
  StepEvents events;
  events.add(StepEvents::Kind::kBegin, {0, 0}).segment.index = 1;
  events.add(StepEvents::Kind::kOver, {0, 0}).segment.index = 2;
  events.add(StepEvents::Kind::kEnd, {0, 0}).segment.index = 3;
  events.add(StepEvents::Kind::kContact, {0, 0}).segment.index = 4;
  events.add(StepEvents::Kind::kTouch, {0, 0}).segment.index = 5;
  {
    const StepEvents::Delivery delivery(events);
    EXPECT_TRUE(events.isDelivering());
    while (const StepEvents::Event* event = events.next()) event->deliver(rules, entity);
  }
  EXPECT_FALSE(events.isDelivering());
  EXPECT_THAT(rules.take(), ElementsAre("begin 0:1", "over 0:2", "end 0:3", "contact 0:4", "touch 0:5"));
}

TEST(StepEventsTest, WhatIsAddedInADeliveryComesLast) {
  StepEvents events;
  events.add(StepEvents::Kind::kBegin, {1, 0});
  events.add(StepEvents::Kind::kBegin, {2, 0});
  const StepEvents::Delivery delivery(events);
  const StepEvents::Event* first = events.next();
  for (std::uint32_t i = 3; i < 100; ++i) events.add(StepEvents::Kind::kEnd, {i, 0});
  EXPECT_EQ(first->entity.index, 1u) << "it stays valid";
  for (std::uint32_t i = 2; i < 100; ++i) EXPECT_EQ(events.next()->entity.index, i);
  EXPECT_EQ(events.next(), nullptr);
}

TEST(StepEventsTest, TheEndOfADeliveryDropsWhatWaits) {
  StepEvents events;
  for (int i = 0; i < 3; ++i) events.add(StepEvents::Kind::kBegin, {0, 0});
  {
    const StepEvents::Delivery delivery(events);
    events.next();
    events.add(StepEvents::Kind::kEnd, {0, 0});
  }
  EXPECT_EQ(events.size(), 0u);
  const StepEvents::Delivery delivery(events);
  EXPECT_EQ(events.next(), nullptr);
}

TEST(StepEventsTest, TruncatesAndTurnsFromAnEventOn) {
  StepEvents events;
  for (int i = 0; i < 3; ++i) events.add(StepEvents::Kind::kBegin, {0, 0}).segment.toHome = Angle(300);
  events.turnHome(1, Angle(35800));
  events.truncate(2);
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(events.since(0)[0].contact.segment.toHome, Angle(300));
  EXPECT_EQ(events.since(0)[1].contact.segment.toHome, Angle(100));
}

}  // namespace
}  // namespace platon::step_events_test
