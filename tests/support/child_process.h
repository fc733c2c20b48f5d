#pragma once

#include <string>
#include <vector>

#include <sys/types.h>

namespace platon::oracle {

/// Which files take the place of a child's standard streams; an empty name leaves the stream as it is.
struct Redirections {
  std::string input;
  std::string output;
  std::string errors;
};

/// A program that was started and is waited for. Throws std::system_error when it cannot be started.
class ChildProcess {
 public:
  /// Starts the program, whose file name is the first argument. `inherited` is a file descriptor that the child may
  /// use under the same number, or -1.
  ChildProcess(const std::vector<std::string>& arguments, const Redirections& redirections, int inherited = -1);
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;
  /// Waits for the child when nobody did.
  ~ChildProcess();

  /// The child's exit code; 128 + signal when a signal ended it.
  int wait();

 private:
  pid_t pid_ = -1;
};

}  // namespace platon::oracle
