#pragma once

#include <sys/types.h>

#include <chrono>
#include <string>
#include <vector>

namespace platon {

/// One of the project's programs, started as a user would, without a display. Its output is kept. Killed, if it still
/// runs, when this goes away.
class Program {
 public:
  /// Starts `name` from the folder that PLATON_BIN names. Throws std::runtime_error when that is not set or fails.
  Program(const std::string& name, const std::vector<std::string>& arguments);
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  /// The exit code, once it has ended; 128 + the signal when one ended it. Throws std::runtime_error, with the output
  /// so far, when that takes longer than `patience`.
  int wait(std::chrono::seconds patience = std::chrono::seconds(60));
  /// Waits until standard error has `text`; what follows it on that line. Throws like `wait`.
  std::string waitForError(const std::string& text, std::chrono::seconds patience = std::chrono::seconds(20));
  /// The same of standard output.
  std::string waitForOutput(const std::string& text, std::chrono::seconds patience = std::chrono::seconds(20));
  void signal(int number) const;

  std::string output();
  std::string errors();

 private:
  struct Stream {
    int handle = -1;
    std::string text;

    void read();
  };

  bool ended();
  std::string waitFor(Stream& stream, const std::string& text, std::chrono::seconds patience);
  [[noreturn]] void fail(const std::string& what);

  std::string name_;
  pid_t pid_ = -1;
  int exitCode_ = -1;
  Stream output_;
  Stream errors_;
};

}  // namespace platon
