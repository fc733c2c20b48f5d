#include "protocol/files/file_watch.h"

#include <system_error>
#include <utility>

namespace platon {

FileWatch::FileWatch(std::vector<std::string> files) : files_(std::move(files)), known_(look()), last_(known_) {}

std::vector<FileWatch::Stamp> FileWatch::look() const {
  std::vector<Stamp> stamps;
  for (const std::string& file : files_) {
    std::error_code fault;
    const auto time = std::filesystem::last_write_time(file, fault);
    const std::uintmax_t size = fault ? 0 : std::filesystem::file_size(file, fault);
    stamps.push_back(fault ? Stamp() : Stamp{time, size});
  }
  return stamps;
}

bool FileWatch::poll(Time now) {
  if (now < nextLook_) return false;
  nextLook_ = now + kInterval;
  const std::vector<Stamp> before = std::exchange(last_, look());
  if (last_ == known_ || last_ != before) return false;
  known_ = last_;
  return true;
}

}  // namespace platon
