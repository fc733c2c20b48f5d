#include "tests/support/server_process.h"

#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <stdexcept>

namespace platon {
namespace {

std::string program() {
  const char* folder = std::getenv("PLATON_BIN");
  if (!folder) throw std::runtime_error("PLATON_BIN names no folder with platon-server; run this test by ctest");
  return std::string(folder) + "/platon-server";
}

}  // namespace

ServerProcess::ServerProcess(const std::vector<std::string>& arguments) {
  std::vector<std::string> all{program()};
  all.insert(all.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& argument : all) argv.push_back(argument.data());
  argv.push_back(nullptr);
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("no pipe");
  pid_ = fork();
  if (pid_ == 0) {
    dup2(ends[1], STDERR_FILENO);
    close(ends[0]);
    close(ends[1]);
    execv(argv[0], argv.data());
    _exit(127);
  }
  close(ends[1]);
  errors_ = ends[0];
}

ServerProcess::~ServerProcess() {
  if (pid_ > 0) {
    signal(SIGKILL);
    wait();
  }
  close(errors_);
}

std::string ServerProcess::line() {
  for (;;) {
    const std::size_t end = read_.find('\n');
    if (end != std::string::npos) {
      const std::string line = read_.substr(0, end);
      read_.erase(0, end + 1);
      return line;
    }
    pollfd stream{errors_, POLLIN, 0};
    char buffer[512];
    const ssize_t size = poll(&stream, 1, 5000) == 1 ? read(errors_, buffer, sizeof buffer) : 0;
    if (size <= 0) return "";
    read_.append(buffer, static_cast<std::size_t>(size));
  }
}

void ServerProcess::signal(int number) const { kill(pid_, number); }

int ServerProcess::wait() {
  int status = 0;
  waitpid(pid_, &status, 0);
  pid_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace platon
