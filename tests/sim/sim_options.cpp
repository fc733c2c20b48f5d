#include "tests/sim/sim_options.h"

#include <algorithm>
#include <charconv>
#include <limits>

namespace platon::sim {

Options::Options(const std::vector<std::string>& arguments, const std::vector<std::string>& valued,
                 const std::vector<std::string>& flags) {
  const auto contains = [](const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  for (auto argument = arguments.begin(); argument != arguments.end(); ++argument) {
    if (argument->rfind("--", 0) != 0) {
      positionals_.push_back(*argument);
      continue;
    }
    const std::size_t equals = argument->find('=');
    const std::string name = argument->substr(2, equals == std::string::npos ? equals : equals - 2);
    if (contains(flags, name) && equals == std::string::npos) {
      values_[name] = "";
    } else if (!contains(valued, name)) {
      throw UsageError("unknown option " + *argument + " (see platon-sim --help)");
    } else if (equals != std::string::npos) {
      values_[name] = argument->substr(equals + 1);
    } else if (argument + 1 == arguments.end()) {
      throw UsageError("option " + *argument + " needs a value");
    } else {
      values_[name] = *++argument;
    }
  }
}

std::string Options::text(const std::string& name, const std::string& fallback) const {
  const auto found = values_.find(name);
  return found == values_.end() ? fallback : found->second;
}

std::int64_t Options::number(const std::string& name, std::int64_t fallback, std::int64_t low,
                             std::int64_t high) const {
  if (!has(name)) return fallback;
  const auto value = wholeNumber(values_.at(name), low, high);
  if (value) return *value;
  throw UsageError("--" + name + " must be an integer from " + std::to_string(low) + " to " + std::to_string(high) +
                   ", not '" + values_.at(name) + "'");
}

std::uint64_t Options::seed() const {
  return static_cast<std::uint64_t>(number("seed", 1, 0, std::numeric_limits<std::int64_t>::max()));
}

const std::string& Options::onlyPositional(const char* usage) const {
  if (positionals_.size() == 1) return positionals_.front();
  throw UsageError(usage);
}

std::optional<std::int64_t> wholeNumber(std::string_view text, std::int64_t low, std::int64_t high) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < low || value > high) return std::nullopt;
  return value;
}

}  // namespace platon::sim
