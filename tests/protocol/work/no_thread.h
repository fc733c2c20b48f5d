#pragma once

#include <functional>
#include <system_error>
#include <thread>

namespace platon {

/// A ThreadStart on a machine that has no thread left.
inline std::thread noThread(const std::function<void()>& /*run*/) {
  throw std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again));
}

}  // namespace platon
