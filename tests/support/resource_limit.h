#pragma once

#include <sys/resource.h>

#include <csignal>

namespace platon {

/// The soft limit of a resource of this process, for as long as the object lives.
class ResourceLimit {
 public:
  ResourceLimit(__rlimit_resource resource, rlim_t soft) : resource_(resource) {
    getrlimit(resource_, &before_);
    const rlimit limit{soft, before_.rlim_max};
    setrlimit(resource_, &limit);
  }
  ~ResourceLimit() { setrlimit(resource_, &before_); }
  ResourceLimit(const ResourceLimit&) = delete;
  ResourceLimit& operator=(const ResourceLimit&) = delete;

 private:
  __rlimit_resource resource_;
  rlimit before_{};
};

/// Simulates a full disk: no file of this process takes bytes beyond a size (EFBIG).
class FullDisk {
 public:
  explicit FullDisk(rlim_t fileBytes) : before_(std::signal(SIGXFSZ, SIG_IGN)), limit_(RLIMIT_FSIZE, fileBytes) {}
  ~FullDisk() { std::signal(SIGXFSZ, before_); }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  void (*before_)(int);
  ResourceLimit limit_;
};

}  // namespace platon
