#pragma once

#include <string>
#include <vector>

#include <sys/types.h>

namespace platon {

/// The program `platon-server`, whose standard error is read.
class ServerProcess {
 public:
  /// Runs the program in PLATON_BIN.
  explicit ServerProcess(const std::vector<std::string>& arguments);
  /// Kills it when it still runs.
  ~ServerProcess();
  ServerProcess(const ServerProcess&) = delete;
  ServerProcess& operator=(const ServerProcess&) = delete;

  /// The next line of standard error; empty at its end or when none comes within 5 s.
  std::string line();
  void signal(int number) const;
  /// Its exit code; -1 when a signal ended it.
  int wait();

 private:
  pid_t pid_ = -1;
  int errors_ = -1;
  std::string read_;
};

}  // namespace platon
