#include "client/ui/controls/control.h"

#include <set>
#include <string_view>

#include <gtest/gtest.h>

namespace platon::control_test {
namespace {

TEST(Control, EachHasAWordAndANameOfItsOwn) {
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < kControlCount; ++i) {
    const auto control = static_cast<Control>(i);
    EXPECT_EQ(controlNamed(wordOf(control)), control);
    EXPECT_TRUE(names.insert(nameOf(control)).second) << nameOf(control);
  }
  EXPECT_FALSE(controlNamed("fly"));
  EXPECT_FALSE(controlNamed(""));
}

}  // namespace
}  // namespace platon::control_test
