#include "client/menu/pages/failure_page.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace platon {
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

}  // namespace
}  // namespace platon
