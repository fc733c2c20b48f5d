#pragma once

#include <gtest/gtest.h>

#include <string>

#include "tests/support/process.h"

namespace platon {

/// What a server, which was started with --metrics at an IPv4 address, answers to a request for its metrics.
inline std::string servedMetrics(Process& server) {
  const std::string address = server.waitForError("metrics on ");
  const ProcessResult answer = runProcess({"bash", "-c",
                                           "exec 3<>/dev/tcp/127.0.0.1/\"$0\" && printf "
                                           "'GET /metrics HTTP/1.1\\r\\n\\r\\n' >&3 && cat <&3",
                                           address.substr(address.find(':') + 1)});
  EXPECT_EQ(answer.exitCode, 0) << answer.errors;
  return answer.output;
}

}  // namespace platon
