#pragma once

#include <optional>
#include <string>

namespace platon {

/// Sets or unsets an environment variable of this process. The destructor restores its former value.
class EnvironmentVariable {
 public:
  /// No value: unsets the variable.
  EnvironmentVariable(std::string name, const std::optional<std::string>& value);
  ~EnvironmentVariable();
  EnvironmentVariable(const EnvironmentVariable&) = delete;
  EnvironmentVariable& operator=(const EnvironmentVariable&) = delete;

  void set(const std::optional<std::string>& value) const;

 private:
  std::string name_;
  std::optional<std::string> former_;
};

}  // namespace platon
