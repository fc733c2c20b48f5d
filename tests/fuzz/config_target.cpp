#include <algorithm>

#include "server/program/options.h"
#include "tests/fuzz/fuzz_targets.h"

namespace platon::fuzz {
namespace {

bool isErrorLine(const std::string& line) {
  return line.starts_with("file:") && line.find(": error: ") != std::string::npos &&
         std::all_of(line.begin(), line.end(), [](char byte) { return byte >= ' ' && byte <= '~'; });
}

}  // namespace

std::string configFault(Bytes bytes) {
  const std::string text(bytes.begin(), bytes.end());
  ServerOptions options;
  const std::vector<std::string> errors = readConfig(text, "file", options);
  if (!std::all_of(errors.begin(), errors.end(), isErrorLine)) return "an error that is no line of the form";
  for (const ServerOption& option : serverOptions()) {
    ServerOptions other;
    if (setOption(option, valueOf(option, options), other)) return "an option has a value that it refuses";
  }
  ServerOptions again = options;
  const bool same = readConfig(text, "file", again) == errors && again == options;
  return same ? std::string() : "reading the text again changes something";
}

}  // namespace platon::fuzz
