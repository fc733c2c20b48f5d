#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace platon {

/// The options and arguments of a program. They are read with CLI11, which only the source of this class includes,
/// since it takes longer to compile than all that uses it. Values are written when the command line is read, and must
/// outlive this object.
class ProgramOptions {
 public:
  /// What has been added, to say more about it.
  class Option {
   public:
    explicit Option(CLI::Option* option) : option_(option) {}

    Option& required();
    /// What stands for the value in the help.
    Option& placeholder(const std::string& text);
    /// As above, instead of all that the help says of the value.
    Option& valueText(const std::string& text);
    /// The heading in the help.
    Option& group(const std::string& heading);
    /// Shows the present value in the help as the default.
    Option& showDefault();
    /// Refuses other values.
    Option& range(int min, int max);
    /// Unlike CLI::Range, refuses "nan".
    Option& range(double min, double max);
    Option& oneOf(const std::vector<int>& values);
    Option& existingFolder();
    /// Takes so many texts, one after the other.
    Option& texts(int least, int most);
    /// Refuses this option without the other one, or with it.
    Option& needs(const Option& other);
    Option& excludes(const Option& other);

   private:
    CLI::Option* option_;
  };

  /// With --help and --version. `about` is the first paragraph of the help.
  ProgramOptions(const std::string& program, const std::string& about);

  /// `names` is "--name", "-n,--name", or "NAME" for an argument. T is std::string, int, std::uint64_t, double, an
  /// optional one of these, std::int64_t, std::uint32_t or a vector of texts.
  template <typename T>
  Option add(const std::string& names, T& value, const std::string& help);
  Option addFlag(const std::string& names, bool& value, const std::string& help);
  /// A word, in any case, that stands for a number.
  Option addWord(const std::string& names, int& value, const std::map<std::string, int>& words,
                 const std::string& help);

  /// A command with options of its own. Then one command must be given.
  ProgramOptions addCommand(const std::string& name, const std::string& help);

  /// Reads the command line. False after printing help or version. Throws ProgramError with kUsage, which names the
  /// option and how to get help.
  bool read(int argc, const char* const* argv);
  /// Throws the same for what is wrong with a value.
  [[noreturn]] void refuse(std::string why) const;
  /// Whether the option, argument or, without a name, command was given.
  bool given(const std::string& name) const;
  bool given() const;

  std::string help() const;

 private:
  explicit ProgramOptions(std::shared_ptr<CLI::App> app) : app_(std::move(app)) {}

  std::shared_ptr<CLI::App> app_;
};

}  // namespace platon
