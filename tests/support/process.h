#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace platon {

struct ProcessOptions {
  std::filesystem::path folder;     ///< working folder; empty: that of the test
  std::filesystem::path inputFile;  ///< file read as standard input; empty: the test's standard input
  bool captureOutput = true;        ///< keep standard output and error; otherwise they go where the test's go
  int inheritedDescriptor = -1;     ///< file descriptor that stays open in the process, under the same number
};

/// A child process. It has no display. The destructor kills it if it still runs.
class Process {
 public:
  /// Starts the program command[0], looked up in PATH if it has no slash, with the arguments that follow. A program
  /// that cannot be executed exits with 127. Throws std::system_error if no process can be made.
  explicit Process(const std::vector<std::string>& command, const ProcessOptions& options = {});
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  /// Waits for the end. Returns the exit code, or 128 + the signal that ended the process. Throws std::runtime_error,
  /// with the output so far, when that takes longer than `limit`.
  int wait(std::chrono::seconds limit = std::chrono::seconds(60));
  /// Waits until a line of standard error contains `text`. Returns the rest of that line. Throws like `wait`, also when
  /// the process ends first.
  std::string waitForError(const std::string& text, std::chrono::seconds limit = std::chrono::seconds(60));
  /// The same for standard output.
  std::string waitForOutput(const std::string& text, std::chrono::seconds limit = std::chrono::seconds(60));
  /// The next line of standard error that this function has not returned yet; empty if the process ends first.
  /// Throws like `wait`.
  std::string nextErrorLine(std::chrono::seconds limit = std::chrono::seconds(60));
  void signal(int number) const;
  pid_t id() const { return pid_; }

  /// Captured standard output so far.
  std::string output();
  /// Captured standard error so far.
  std::string errors();

 private:
  struct Stream {
    int descriptor = -1;
    std::string text;

    void read();
  };

  bool ended();
  void waitForActivity();
  std::string waitFor(Stream& stream, const std::string& text, std::chrono::seconds limit);
  [[noreturn]] void fail(const std::string& what);

  std::string name_;
  pid_t pid_ = -1;
  int exitCode_ = -1;
  Stream output_;
  Stream errors_;
  std::size_t returnedErrors_ = 0;
};

/// Exit code and captured output of a process that has ended.
struct ProcessResult {
  int exitCode = 0;
  std::string output;
  std::string errors;
};

/// Runs a program to its end. Throws like Process.
ProcessResult runProcess(const std::vector<std::string>& command, const ProcessOptions& options = {});

/// The command that runs one of the project's programs, which lie in the folder that PLATON_BIN names. Throws
/// std::runtime_error if PLATON_BIN is not set.
std::vector<std::string> platonCommand(const std::string& program, const std::vector<std::string>& arguments = {});

/// The words of a text, separated by spaces.
std::vector<std::string> wordsOf(const std::string& text);

}  // namespace platon
