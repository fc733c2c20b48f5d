#include "client/session/round_trip_list.h"

#include <gtest/gtest.h>

namespace platon::round_trip_list_test {
namespace {

using std::chrono::microseconds;
using std::chrono::seconds;

TEST(RoundTripList, ASlotHasWhatTheNewestMessageTells) {
  RoundTripList list;
  EXPECT_EQ(list.of(0, Moment(0)), std::nullopt);
  list.receive({{codeOfRoundTrip(20), kNoRoundTrip, codeOfRoundTrip(5000)}}, seconds(1));
  EXPECT_EQ(list.of(0, seconds(1)), 20u);
  EXPECT_EQ(list.of(1, seconds(1)), std::nullopt);
  EXPECT_EQ(list.of(2, seconds(1)), kMaxRoundTripMs);
  EXPECT_EQ(list.of(3, seconds(1)), std::nullopt);
  list.receive({{codeOfRoundTrip(40)}}, seconds(2));
  EXPECT_EQ(list.of(0, seconds(2)), 40u);
  EXPECT_EQ(list.of(2, seconds(2)), std::nullopt);
}

TEST(RoundTripList, AnOldOneIsForgotten) {
  RoundTripList list;
  list.receive({{codeOfRoundTrip(20)}}, seconds(1));
  EXPECT_EQ(list.of(0, seconds(1) + RoundTripList::kTimeout), 20u);
  EXPECT_EQ(list.of(0, seconds(1) + RoundTripList::kTimeout + microseconds(1)), std::nullopt);
}

}  // namespace
}  // namespace platon::round_trip_list_test
