#include "tests/support/program.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <stdexcept>
#include <thread>

namespace platon {

namespace {

constexpr std::chrono::milliseconds kLook{10};

struct Pipe {
  int readEnd = -1;
  int writeEnd = -1;

  Pipe() {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe left");
    readEnd = ends[0];
    writeEnd = ends[1];
    fcntl(readEnd, F_SETFL, O_NONBLOCK);
  }
};

[[noreturn]] void become(const std::string& path, const std::vector<std::string>& arguments, int output, int errors) {
  std::vector<char*> raw = {const_cast<char*>(path.c_str())};
  for (const std::string& argument : arguments) raw.push_back(const_cast<char*>(argument.c_str()));
  raw.push_back(nullptr);
  dup2(output, STDOUT_FILENO);
  dup2(errors, STDERR_FILENO);
  unsetenv("DISPLAY");
  unsetenv("WAYLAND_DISPLAY");
  execv(path.c_str(), raw.data());
  _exit(127);
}

}  // namespace

Program::Program(const std::string& name, const std::vector<std::string>& arguments) : name_(name) {
  const char* const folder = std::getenv("PLATON_BIN");
  if (folder == nullptr) throw std::runtime_error("PLATON_BIN is not set: run these tests by ctest");
  const Pipe output;
  const Pipe errors;
  pid_ = fork();
  if (pid_ == 0) become(std::string(folder) + "/" + name, arguments, output.writeEnd, errors.writeEnd);
  close(output.writeEnd);
  close(errors.writeEnd);
  output_.handle = output.readEnd;
  errors_.handle = errors.readEnd;
  if (pid_ < 0) throw std::runtime_error("no process left");
}

Program::~Program() {
  if (!ended()) {
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  close(output_.handle);
  close(errors_.handle);
}

void Program::Stream::read() {
  std::array<char, 4096> buffer;
  for (ssize_t count; (count = ::read(handle, buffer.data(), buffer.size())) > 0;) {
    text.append(buffer.data(), static_cast<std::size_t>(count));
  }
}

bool Program::ended() {
  int status = 0;
  if (exitCode_ < 0 && waitpid(pid_, &status, WNOHANG) == pid_) {
    exitCode_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }
  return exitCode_ >= 0;
}

int Program::wait(std::chrono::seconds patience) {
  const auto end = std::chrono::steady_clock::now() + patience;
  while (!ended()) {
    output_.read();
    errors_.read();
    if (std::chrono::steady_clock::now() > end) fail("does not end");
    std::this_thread::sleep_for(kLook);
  }
  return exitCode_;
}

std::string Program::waitFor(Stream& stream, const std::string& text, std::chrono::seconds patience) {
  const auto end = std::chrono::steady_clock::now() + patience;
  while (true) {
    const bool last = ended();
    stream.read();
    const std::size_t found = stream.text.find(text);
    const std::size_t line = stream.text.find('\n', found);
    if (found != std::string::npos && line != std::string::npos) {
      return stream.text.substr(found + text.size(), line - found - text.size());
    }
    if (last || std::chrono::steady_clock::now() > end) fail("does not say '" + text + "'");
    std::this_thread::sleep_for(kLook);
  }
}

std::string Program::waitForError(const std::string& text, std::chrono::seconds patience) {
  return waitFor(errors_, text, patience);
}

std::string Program::waitForOutput(const std::string& text, std::chrono::seconds patience) {
  return waitFor(output_, text, patience);
}

void Program::signal(int number) const {
  if (exitCode_ < 0) kill(pid_, number);
}

std::string Program::output() {
  output_.read();
  return output_.text;
}

std::string Program::errors() {
  errors_.read();
  return errors_.text;
}

void Program::fail(const std::string& what) {
  throw std::runtime_error(name_ + " " + what + "; stdout: " + output() + "; stderr: " + errors());
}

}  // namespace platon
