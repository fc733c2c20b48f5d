#include "tests/exactness/reference/course.h"

#include <gtest/gtest.h>

#include "tests/exactness/oracle/random_source.h"
#include "tests/exactness/reference/terrain.h"

namespace platon::reference::course_test {
namespace {

TEST(CourseTest, FindsExactlyTheObstaclesInReach) {
  oracle::RandomSource random(5);
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const ExactScene scene = randomTerrain(seed, 300).scene;
    const Course course(scene);
    for (int i = 0; i < 50; ++i) {
      const oracle::Vec by = random.vector(40000);
      const oracle::Vec near = scene.lines[random.below(scene.lines.size())].a + random.vector(40000);
      const Reach reach({mpz_class(near.x), mpz_class(near.y), 1}, static_cast<double>(by.x),
                        static_cast<double>(by.y));
      std::vector<std::size_t> expected;
      for (std::size_t k = 0; k < scene.lines.size(); ++k) {
        if (reach.touches(Reach(course[k].box))) expected.push_back(k);
      }
      EXPECT_EQ(course.near(reach), expected);
    }
  }
}

TEST(CourseTest, QuotientsOfNumbersBeyondDoubleAreRight) {
  const mpz_class big = mpz_class(1) << 3000;
  EXPECT_EQ(quotient(3 * big, 2 * big), 1.5);
  EXPECT_EQ(quotient(-5, 4), -1.25);
}

}  // namespace
}  // namespace platon::reference::course_test
