#include "protocol/program_options.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdint>
#include <optional>

#include "platon_version.h"
#include "protocol/program_error.h"

namespace platon {

ProgramOptions::Option& ProgramOptions::Option::required() { return option_->required(), *this; }

ProgramOptions::Option& ProgramOptions::Option::placeholder(const std::string& text) {
  return option_->type_name(text), *this;
}

ProgramOptions::Option& ProgramOptions::Option::valueText(const std::string& text) {
  return option_->option_text(text), *this;
}

ProgramOptions::Option& ProgramOptions::Option::group(const std::string& heading) {
  return option_->group(heading), *this;
}

ProgramOptions::Option& ProgramOptions::Option::showDefault() { return option_->capture_default_str(), *this; }

ProgramOptions::Option& ProgramOptions::Option::range(int min, int max) {
  return option_->check(CLI::Range(min, max)), *this;
}

ProgramOptions::Option& ProgramOptions::Option::range(double min, double max) {
  const auto refuse = [min, max](const std::string& text) {
    double value = 0;
    const bool valid = CLI::detail::lexical_cast(text, value) && value >= min && value <= max;
    return valid ? std::string() : fmt::format("'{}' is not a number from {} to {}", text, min, max);
  };
  return option_->check(CLI::Validator(refuse, fmt::format("FLOAT in [{} - {}]", min, max))), *this;
}

ProgramOptions::Option& ProgramOptions::Option::oneOf(const std::vector<int>& values) {
  return option_->check(CLI::IsMember(values)), *this;
}

ProgramOptions::Option& ProgramOptions::Option::existingFolder() {
  return option_->check(CLI::ExistingDirectory), *this;
}

ProgramOptions::Option& ProgramOptions::Option::texts(int least, int most) {
  return option_->expected(least, most)->allow_extra_args(false), *this;
}

ProgramOptions::Option& ProgramOptions::Option::needs(const Option& other) {
  return option_->needs(other.option_), *this;
}

ProgramOptions::Option& ProgramOptions::Option::excludes(const Option& other) {
  return option_->excludes(other.option_), *this;
}

ProgramOptions::ProgramOptions(const std::string& program, const std::string& about)
    : app_(std::make_shared<CLI::App>(about, program)) {
  app_->set_version_flag("--version", program + " " + std::string(kVersion));
}

template <typename T>
ProgramOptions::Option ProgramOptions::add(const std::string& names, T& value, const std::string& help) {
  return Option(app_->add_option(names, value, help));
}

template ProgramOptions::Option ProgramOptions::add(const std::string&, std::string&, const std::string&);
template ProgramOptions::Option ProgramOptions::add(const std::string&, int&, const std::string&);
template ProgramOptions::Option ProgramOptions::add(const std::string&, std::int64_t&, const std::string&);
template ProgramOptions::Option ProgramOptions::add(const std::string&, std::uint32_t&, const std::string&);
template ProgramOptions::Option ProgramOptions::add(const std::string&, std::uint64_t&, const std::string&);
template ProgramOptions::Option ProgramOptions::add(const std::string&, double&, const std::string&);
template ProgramOptions::Option ProgramOptions::add(const std::string&, std::optional<std::string>&,
                                                    const std::string&);
template ProgramOptions::Option ProgramOptions::add(const std::string&, std::optional<int>&, const std::string&);
template ProgramOptions::Option ProgramOptions::add(const std::string&, std::optional<std::uint64_t>&,
                                                    const std::string&);
template ProgramOptions::Option ProgramOptions::add(const std::string&, std::optional<double>&, const std::string&);
template ProgramOptions::Option ProgramOptions::add(const std::string&, std::vector<std::string>&, const std::string&);

ProgramOptions::Option ProgramOptions::addFlag(const std::string& names, bool& value, const std::string& help) {
  return Option(app_->add_flag(names, value, help));
}

ProgramOptions::Option ProgramOptions::addWord(const std::string& names, int& value,
                                               const std::map<std::string, int>& words, const std::string& help) {
  return Option(app_->add_option(names, value, help)->transform(CLI::CheckedTransformer(words, CLI::ignore_case)));
}

ProgramOptions ProgramOptions::addCommand(const std::string& name, const std::string& help) {
  app_->require_subcommand(1);
  return ProgramOptions(std::shared_ptr<CLI::App>(app_, app_->add_subcommand(name, help)));
}

bool ProgramOptions::read(int argc, const char* const* argv) {
  try {
    app_->parse(argc, argv);
    return true;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {
      app_->exit(error);
      return false;
    }
    const std::vector<std::string> unknown = app_->remaining();
    const bool lacksCommand = app_->get_require_subcommand_min() > 0 && app_->get_subcommands().empty();
    if (!lacksCommand || unknown.empty()) refuse(error.what());
    refuse(
        fmt::format("'{}' is not {}", unknown.front(), unknown.front().starts_with('-') ? "an option" : "a command"));
  }
}

void ProgramOptions::refuse(std::string why) const {
  std::replace(why.begin(), why.end(), '\n', ' ');
  throw ProgramError(ProgramError::kUsage, why + " (see " + app_->get_name() + " --help)");
}

bool ProgramOptions::given(const std::string& name) const { return app_->count(name) > 0; }

bool ProgramOptions::given() const { return app_->parsed(); }

std::string ProgramOptions::help() const { return app_->help(); }

}  // namespace platon
