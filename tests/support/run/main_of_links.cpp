// The main function of a program with the tests of several files. Under the name of one of the files, as of a link to
// it, it runs the tests of that file alone.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace {

// The filter that lets through the tests of the file NAME.cpp; no test at all if there are none.
std::string filterOfFile(const std::string& name) {
  std::string filter;
  const testing::UnitTest& all = *testing::UnitTest::GetInstance();
  for (int i = 0; i < all.total_test_suite_count(); ++i) {
    const testing::TestSuite& suite = *all.GetTestSuite(i);
    for (int j = 0; j < suite.total_test_count(); ++j) {
      const testing::TestInfo& test = *suite.GetTestInfo(j);
      if (std::filesystem::path(test.file()).stem() != name) continue;
      filter += (filter.empty() ? "" : ":") + std::string(suite.name()) + "." + test.name();
    }
  }
  return filter.empty() ? "-*" : filter;
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleMock(&argc, argv);
  const std::string name = std::filesystem::path(argv[0]).filename();
  if (!name.ends_with("_and_others") && GTEST_FLAG_GET(filter) == "*") GTEST_FLAG_SET(filter, filterOfFile(name));
  return RUN_ALL_TESTS();
}
