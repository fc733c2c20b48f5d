#pragma once

#include <iosfwd>
#include <string>

namespace platon {

/// Where the console takes its commands from and writes to.
struct ConsoleTerminal {
  std::istream& commands;
  std::ostream& results;
  std::ostream& talk;        ///< errors and the prompt
  bool interactive = false;  ///< a person types: show a prompt
};

/// Sends each line to the server that listens at the path and prints its reply, until the commands end or one of them
/// is `quit`. Empty lines and lines that begin with `#` are skipped. Returns the exit code: 0, or 1 if a command failed
/// or the server did not answer.
int runConsole(const std::string& path, const ConsoleTerminal& terminal);

}  // namespace platon
