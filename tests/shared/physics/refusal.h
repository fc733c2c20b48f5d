#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace platon {

/// The text of the std::invalid_argument that `call` throws; empty if it throws nothing.
inline std::string refusal(const std::function<void()>& call) {
  try {
    call();
  } catch (const std::invalid_argument& reason) {
    return reason.what();
  }
  return "";
}

}  // namespace platon
