#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "protocol/files/word_reader.h"
#include "server/app/server_options.h"

namespace platon {

/// Reads a number of bytes: a whole number from 1 on, which K, M or G may follow for KiB, MiB or GiB. Nothing if the
/// text is anything else, or the number does not fit 64 bits.
std::optional<std::uint64_t> parseByteSize(std::string_view text);

/// An option of the server. Command line, configuration file, `--print-config` and the reload all follow this
/// description.
struct ServerOption {
  using Field =
      std::variant<std::string ServerOptions::*, std::uint16_t ServerOptions::*, std::uint32_t ServerOptions::*,
                   LogFormat ServerOptions::*, std::vector<std::string> ServerOptions::*>;

  std::string_view name;         ///< `--name` on the command line, `name` in the file
  std::string_view placeholder;  ///< of its value
  Field field;
  std::string_view help;            ///< a sentence without its full stop, and without range and default
  std::string_view whenEmpty = {};  ///< of a text or list: what the empty value means
  bool isPath = false;              ///< in the file: relative to the folder of the file, unless empty
  bool needsRestart = true;         ///< a reload does not change it
  std::int64_t least = 0;           ///< of a number
  std::int64_t most = 0;
  std::string_view mustBe = {};                   ///< of a text: what `accepts` asks for
  bool (*accepts)(const std::string&) = nullptr;  ///< of a text that is not empty; null: every text is accepted

  bool isList() const { return std::holds_alternative<std::vector<std::string> ServerOptions::*>(field); }
};

/// All options, in the order in which they are listed. `levels` has no name on the command line: there the levels are
/// the arguments.
std::span<const ServerOption> serverOptions();
inline constexpr std::string_view kLevelsOption = "levels";

/// A value of an option as a configuration file has it.
using OptionValue = std::variant<std::string, std::int64_t, std::vector<std::string>>;

OptionValue valueOf(const ServerOption& option, const ServerOptions& options);
/// Sets the option. On failure nothing changes, and the error is the rest of a sentence that begins with the name of
/// the option.
std::optional<ParseError> setOption(const ServerOption& option, const OptionValue& value, ServerOptions& options);
/// The same for a value that is given on the command line.
std::optional<ParseError> setOption(const ServerOption& option, const std::string& text, ServerOptions& options);

/// What `--print-config` prints: a configuration file in which every option has its default and a comment.
std::string printedConfig();

/// Reads the text of a configuration file (docs/hosting.md) into `options`; options that it does not contain, or
/// contains with an error, keep their values. Paths are relative to the folder of `file`. Returns all errors, each as
/// `file:line:column: error: …`, in the order of the text.
std::vector<std::string> readConfig(std::string_view text, const std::string& file, ServerOptions& options);

/// The same for a file. An error is also that the file cannot be read.
std::vector<std::string> readConfigFile(const std::string& path, ServerOptions& options);

}  // namespace platon
