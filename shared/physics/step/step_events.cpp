#include "shared/physics/step/step_events.h"

namespace platon {

void StepEvents::Event::deliver(Rules& rules, Entity& handle) const {
  switch (kind) {
    case Kind::kBegin:
      return rules.beginContact(handle, contact.segment);
    case Kind::kOver:
      return rules.overContact(handle, contact.segment);
    case Kind::kEnd:
      return rules.endContact(handle, contact.segment);
    case Kind::kContact:
      return rules.contact(handle, contact);
    case Kind::kTouch:
      return rules.touchContact(handle, contact.segment);
  }
}

StepEvents::Delivery::~Delivery() {
  events_.events_.clear();
  events_.batch_.clear();
  events_.delivered_ = 0;
  events_.delivering_ = false;
}

void StepEvents::turnHome(std::size_t first, Angle turn) {
  if (turn == Angle()) return;
  for (Event& event : std::span(events_).subspan(first))
    event.contact.segment.toHome = event.contact.segment.toHome + turn;
}

// A callback may add events: they make the next batch.
const StepEvents::Event* StepEvents::next() {
  if (delivered_ == batch_.size()) {
    batch_.clear();
    batch_.swap(events_);
    delivered_ = 0;
  }
  return delivered_ == batch_.size() ? nullptr : &batch_[delivered_++];
}

}  // namespace platon
