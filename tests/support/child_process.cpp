#include "tests/support/child_process.h"

#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace platon::oracle {
namespace {

constexpr int kCannotStart = 127;

void redirect(const std::string& file, int stream, int flags) {
  if (file.empty()) return;
  const int opened = open(file.c_str(), flags, 0600);
  if (opened < 0 || dup2(opened, stream) < 0) _exit(kCannotStart);
}

[[noreturn]] void become(const std::vector<std::string>& arguments, const Redirections& files, int inherited) {
  redirect(files.input, STDIN_FILENO, O_RDONLY);
  redirect(files.output, STDOUT_FILENO, O_WRONLY | O_CREAT | O_TRUNC);
  redirect(files.errors, STDERR_FILENO, O_WRONLY | O_CREAT | O_TRUNC);
  if (inherited >= 0) fcntl(inherited, F_SETFD, 0);
  std::vector<char*> raw;
  for (const std::string& argument : arguments) raw.push_back(const_cast<char*>(argument.c_str()));
  raw.push_back(nullptr);
  execvp(raw.front(), raw.data());
  _exit(kCannotStart);
}

}  // namespace

ChildProcess::ChildProcess(const std::vector<std::string>& arguments, const Redirections& redirections, int inherited)
    : pid_(fork()) {
  if (pid_ < 0) throw std::system_error(errno, std::generic_category(), "cannot start " + arguments.front());
  if (pid_ == 0) become(arguments, redirections, inherited);
}

ChildProcess::~ChildProcess() {
  if (pid_ > 0) wait();
}

int ChildProcess::wait() {
  int status = 0;
  while (waitpid(pid_, &status, 0) < 0)
    if (errno != EINTR) throw std::system_error(errno, std::generic_category(), "cannot wait for a child");
  pid_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace platon::oracle
