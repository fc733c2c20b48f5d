#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace platon::sim {

/// A command line that cannot be followed: exit code 2. The text says what is wrong and how to mend it.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file that cannot be used as what it should be: exit code 3. Nothing more to say when the text is empty.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The arguments of one command: words and `--name value` options. Written here, because platon-sim needs nothing but
/// the standard library on any machine that it is to be compared on.
class Options {
 public:
  /// `valued` and `flags` list the options that the command knows, without dashes. Throws UsageError.
  Options(const std::vector<std::string>& arguments, const std::vector<std::string>& valued,
          const std::vector<std::string>& flags);

  const std::vector<std::string>& words() const { return words_; }
  bool has(const std::string& name) const { return values_.count(name) != 0; }
  std::string text(const std::string& name, const std::string& fallback) const;
  /// A whole number in [low, high]; throws UsageError otherwise.
  std::int64_t number(const std::string& name, std::int64_t fallback, std::int64_t low, std::int64_t high) const;
  std::uint64_t seed() const;
  /// The one word that the command takes; throws UsageError with `usage` otherwise.
  const std::string& onlyWord(const char* usage) const;

 private:
  std::vector<std::string> words_;
  std::map<std::string, std::string> values_;
};

/// The whole of `text` as a number in [low, high].
std::optional<std::int64_t> wholeNumber(std::string_view text, std::int64_t low, std::int64_t high);

}  // namespace platon::sim
