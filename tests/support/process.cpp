#include "tests/support/process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <system_error>

namespace platon {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kCannotExecute = 127;
constexpr int kPollMilliseconds = 5;

struct Pipe {
  int readEnd = -1;
  int writeEnd = -1;

  explicit Pipe(bool open) {
    std::array<int, 2> ends{-1, -1};
    if (open && pipe2(ends.data(), O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
    if (open) fcntl(ends[0], F_SETFL, O_NONBLOCK);
    readEnd = ends[0];
    writeEnd = ends[1];
  }
};

void redirect(int descriptor, int stream) {
  if (descriptor >= 0) dup2(descriptor, stream);
}

// Runs in the child.
[[noreturn]] void execute(std::vector<char*>& command, const ProcessOptions& options, int output, int errors) {
  if (!options.inputFile.empty()) {
    const int input = open(options.inputFile.c_str(), O_RDONLY);
    if (input < 0) _exit(kCannotExecute);
    redirect(input, STDIN_FILENO);
  }
  redirect(output, STDOUT_FILENO);
  redirect(errors, STDERR_FILENO);
  if (options.inheritedDescriptor >= 0) fcntl(options.inheritedDescriptor, F_SETFD, 0);
  if (!options.folder.empty() && chdir(options.folder.c_str()) != 0) _exit(kCannotExecute);
  unsetenv("DISPLAY");
  unsetenv("WAYLAND_DISPLAY");
  execvp(command.front(), command.data());
  _exit(kCannotExecute);
}

}  // namespace

Process::Process(const std::vector<std::string>& command, const ProcessOptions& options) : name_(command.front()) {
  std::vector<char*> raw;
  for (const std::string& word : command) raw.push_back(const_cast<char*>(word.c_str()));
  raw.push_back(nullptr);
  const Pipe output(options.captureOutput);
  const Pipe errors(options.captureOutput);
  output_.descriptor = output.readEnd;
  errors_.descriptor = errors.readEnd;
  pid_ = fork();
  if (pid_ == 0) execute(raw, options, output.writeEnd, errors.writeEnd);
  if (pid_ < 0) throw std::system_error(errno, std::generic_category(), "cannot start " + name_);
  if (!options.captureOutput) return;
  close(output.writeEnd);
  close(errors.writeEnd);
}

Process::~Process() {
  if (!ended()) {
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  for (const Stream& stream : {output_, errors_}) {
    if (stream.descriptor >= 0) close(stream.descriptor);
  }
}

void Process::Stream::read() {
  if (descriptor < 0) return;
  std::array<char, 65536> buffer;
  ssize_t count = 0;
  while ((count = ::read(descriptor, buffer.data(), buffer.size())) > 0) {
    text.append(buffer.data(), static_cast<std::size_t>(count));
  }
  if (count < 0) return;
  close(descriptor);
  descriptor = -1;
}

bool Process::ended() {
  int status = 0;
  if (exitCode_ < 0 && waitpid(pid_, &status, WNOHANG) == pid_) {
    exitCode_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }
  return exitCode_ >= 0;
}

void Process::waitForActivity() {
  std::array<pollfd, 2> streams{{{output_.descriptor, POLLIN, 0}, {errors_.descriptor, POLLIN, 0}}};
  poll(streams.data(), streams.size(), kPollMilliseconds);
  output_.read();
  errors_.read();
}

int Process::wait(std::chrono::seconds limit) {
  const auto end = Clock::now() + limit;
  while (!ended()) {
    if (Clock::now() > end) fail("does not end");
    waitForActivity();
  }
  return exitCode_;
}

std::string Process::waitFor(Stream& stream, const std::string& text, std::chrono::seconds limit) {
  const auto end = Clock::now() + limit;
  while (true) {
    const bool last = ended();
    stream.read();
    const std::size_t found = stream.text.find(text);
    const std::size_t line = stream.text.find('\n', found);
    if (found != std::string::npos && line != std::string::npos) {
      return stream.text.substr(found + text.size(), line - found - text.size());
    }
    if (last || Clock::now() > end) fail("does not write '" + text + "'");
    waitForActivity();
  }
}

std::string Process::waitForError(const std::string& text, std::chrono::seconds limit) {
  return waitFor(errors_, text, limit);
}

std::string Process::waitForOutput(const std::string& text, std::chrono::seconds limit) {
  return waitFor(output_, text, limit);
}

std::string Process::nextErrorLine(std::chrono::seconds limit) {
  const auto end = Clock::now() + limit;
  while (true) {
    const bool last = ended();
    errors_.read();
    const std::size_t line = errors_.text.find('\n', returnedErrors_);
    if (line != std::string::npos) {
      const std::size_t start = returnedErrors_;
      returnedErrors_ = line + 1;
      return errors_.text.substr(start, line - start);
    }
    if (last) return "";
    if (Clock::now() > end) fail("writes no further line to standard error");
    waitForActivity();
  }
}

void Process::signal(int number) const {
  if (exitCode_ < 0) kill(pid_, number);
}

std::string Process::output() {
  output_.read();
  return output_.text;
}

std::string Process::errors() {
  errors_.read();
  return errors_.text;
}

void Process::fail(const std::string& what) {
  throw std::runtime_error(name_ + " " + what + "; stdout: " + output() + "; stderr: " + errors());
}

ProcessResult runProcess(const std::vector<std::string>& command, const ProcessOptions& options) {
  Process process(command, options);
  const int exitCode = process.wait();
  return {exitCode, process.output(), process.errors()};
}

std::vector<std::string> platonCommand(const std::string& program, const std::vector<std::string>& arguments) {
  const char* const folder = std::getenv("PLATON_BIN");
  if (folder == nullptr) throw std::runtime_error("PLATON_BIN is not set: run this test with ctest");
  std::vector<std::string> command{std::filesystem::absolute(folder) / program};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return command;
}

std::vector<std::string> wordsOf(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

}  // namespace platon
