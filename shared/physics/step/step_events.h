#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "platon/physics/rules.h"

namespace platon {

/// The events of a step, which wait until all entities have moved. They are values, so nothing that a callback does can
/// make them invalid. Keeps its memory between steps.
class StepEvents {
 public:
  enum class Kind : std::uint8_t { kBegin, kOver, kEnd, kContact, kTouch };
  struct Event {
    Kind kind = Kind::kBegin;
    EntityId entity;
    Contact contact;  ///< only its segment, unless the kind is kContact

    /// Whether a later event belongs to this one, or an earlier one.
    bool isPaired() const { return kind == Kind::kBegin || kind == Kind::kEnd; }
    /// Calls the method of the rules that belongs to the kind.
    void deliver(Rules& rules, Entity& handle) const;
  };
  /// While it exists, the events are being delivered. At its end, by an exception too, those that still wait are
  /// dropped.
  class Delivery {
   public:
    explicit Delivery(StepEvents& events) : events_(events) { events_.delivering_ = true; }
    Delivery(const Delivery&) = delete;
    Delivery& operator=(const Delivery&) = delete;
    ~Delivery();

   private:
    StepEvents& events_;
  };

  /// Adds an event and returns its contact, of which only the segment counts, unless the kind is kContact.
  Contact& add(Kind kind, EntityId entity) {
    Event& event = events_.emplace_back();
    event.kind = kind;
    event.entity = entity;
    return event.contact;
  }
  /// Adds these events of the entity.
  void add(std::span<const Event> events, EntityId entity) {
    for (const Event& event : events) events_.emplace_back(event).entity = entity;
  }

  /// Number of events that no delivery has begun with.
  std::size_t size() const { return events_.size(); }
  /// The events from number `first` on; valid until another one is added.
  std::span<const Event> since(std::size_t first) const { return std::span(events_).subspan(first); }
  /// Removes the events from number `first` on.
  void truncate(std::size_t first) {
    events_.erase(events_.begin() + static_cast<std::ptrdiff_t>(first), events_.end());
  }
  /// Adds `turn` to toHome of the events from number `first` on: the home part has changed.
  void turnHome(std::size_t first, Angle turn);

  bool isDelivering() const { return delivering_; }
  /// The next event of a delivery; null after the last one. Valid until the next call, whatever is added.
  const Event* next();

 private:
  std::vector<Event> events_;
  std::vector<Event> batch_;   // the events that are being delivered
  std::size_t delivered_ = 0;  // number of those of the batch
  bool delivering_ = false;
};

}  // namespace platon
