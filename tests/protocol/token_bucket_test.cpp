#include "protocol/token_bucket.h"

#include <gtest/gtest.h>

namespace platon::token_bucket_test {
namespace {

using namespace std::chrono_literals;

const Time kStart{1h};

TEST(TokenBucket, StartsFull) {
  TokenBucket bucket(10, 3, kStart);
  EXPECT_TRUE(bucket.take(2, kStart));
  EXPECT_TRUE(bucket.take(1, kStart));
  EXPECT_FALSE(bucket.take(1, kStart));
}

TEST(TokenBucket, RefillsAtItsRate) {
  TokenBucket bucket(10, 3, kStart);
  EXPECT_TRUE(bucket.take(3, kStart));
  EXPECT_FALSE(bucket.take(1, kStart + 99ms));
  EXPECT_TRUE(bucket.take(1, kStart + 101ms));
}

TEST(TokenBucket, NeverHoldsMoreThanItsLimit) {
  TokenBucket bucket(10, 3, kStart);
  EXPECT_FALSE(bucket.take(4, kStart + 1h));
  EXPECT_TRUE(bucket.take(3, kStart + 1h));
}

TEST(TokenBucket, TimeThatGoesBackAddsNothing) {
  TokenBucket bucket(10, 3, kStart);
  EXPECT_TRUE(bucket.take(3, kStart));
  EXPECT_FALSE(bucket.take(1, kStart - 1s));
}

TEST(TokenBucket, WhatIsAddedCountsUpToItsLimit) {
  TokenBucket bucket(10, 3, kStart);
  EXPECT_TRUE(bucket.take(3, kStart));
  bucket.add(2);
  EXPECT_TRUE(bucket.take(2, kStart));
  bucket.add(100);
  EXPECT_TRUE(bucket.take(3, kStart));
  EXPECT_FALSE(bucket.take(1, kStart));
}

}  // namespace
}  // namespace platon::token_bucket_test
