#pragma once

#include <functional>
#include <stop_token>
#include <system_error>
#include <thread>

namespace platon {

/// A ThreadStart on a machine that has no thread left.
inline std::jthread noThread(const std::function<void(const std::stop_token&)>& /*work*/) {
  throw std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again));
}

}  // namespace platon
