#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace platon::sim {

/// An invalid command line, or a file that cannot be opened: exit code 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An invalid input file, or a failed write: exit code 3. With an empty text, nothing is printed.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The arguments of one command: positional arguments, `--name value` options and `--name` flags. platon-sim does not
/// use CLI11, so that it builds with only the standard library on every machine on which results are compared.
class Options {
 public:
  /// `valued` and `flags` are the names of the command's options, without dashes. Throws UsageError on another option.
  Options(const std::vector<std::string>& arguments, const std::vector<std::string>& valued,
          const std::vector<std::string>& flags);

  const std::vector<std::string>& positionals() const { return positionals_; }
  bool has(const std::string& name) const { return values_.count(name) != 0; }
  std::string text(const std::string& name, const std::string& fallback) const;
  /// The value of an option, an integer in [low, high]; `fallback` without the option. Throws UsageError otherwise.
  std::int64_t number(const std::string& name, std::int64_t fallback, std::int64_t low, std::int64_t high) const;
  /// The value of `--seed`; 1 without the option.
  std::uint64_t seed() const;
  /// The positional argument of a command that takes exactly one; throws UsageError with the text `usage` otherwise.
  const std::string& onlyPositional(const char* usage) const;

 private:
  std::vector<std::string> positionals_;
  std::map<std::string, std::string> values_;
};

/// Parses `text` as an integer in [low, high]; nothing when it is none.
std::optional<std::int64_t> wholeNumber(std::string_view text, std::int64_t low, std::int64_t high);

}  // namespace platon::sim
