#include "server/fleet/agones_port.h"

#include <gtest/gtest.h>

#include "protocol/program_error.h"

namespace platon::agones_port_test {
namespace {

TEST(AgonesPort, IsThatOfTheVariable) {
  EXPECT_EQ(agonesPortOf(nullptr), std::nullopt);
  EXPECT_EQ(agonesPortOf(""), std::nullopt);
  EXPECT_EQ(agonesPortOf("9358"), 9358);
  EXPECT_EQ(agonesPortOf("65535"), 65535);
}

TEST(AgonesPort, AnythingElseIsRefused) {
  for (const char* value : {"0", "65536", "-1", "9358 ", "http", "1.5"}) {
    EXPECT_THROW(agonesPortOf(value), ProgramError) << value;
  }
  try {
    agonesPortOf("x");
  } catch (const ProgramError& error) {
    EXPECT_EQ(error.exitCode(), ProgramError::kUsage);
    EXPECT_STREQ(error.what(),
                 "AGONES_SDK_HTTP_PORT must be a port from 1 to 65535, not 'x'; unset it to run without Agones");
  }
}

}  // namespace
}  // namespace platon::agones_port_test
