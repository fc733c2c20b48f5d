#include "client/menu/pages/failure_page.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace platon::failure_page_test {
namespace {

TEST(FailurePage, ShowsEachLineOfTheReasonAndOffersToTryAgain) {
  std::string called;
  const MenuPage page = failurePage(
      "Title", "line one\nline two", [&] { called += "retry "; }, [&] { called += "back "; });
  EXPECT_EQ(page.notes, (std::vector<std::string>{"line one", "line two"}));
  EXPECT_TRUE(page.warning);
  for (const MenuItem& item : page.items) item.choose();
  page.back();
  EXPECT_EQ(called, "retry back back ");
}

TEST(FailurePage, OffersTheOtherWayFirst) {
  const MenuItem other{.name = "Join example.org:7777", .choose = [] {}};
  const MenuPage page = failurePage(
      "Title", "why", [] {}, [] {}, other);
  ASSERT_EQ(page.items.size(), 3u);
  EXPECT_EQ(page.items[0].name, "Join example.org:7777");
}

}  // namespace
}  // namespace platon::failure_page_test
