#include "server/program/command_line.h"

#include <algorithm>
#include <utility>

#include "protocol/program_options.h"
#include "server/program/options.h"

namespace platon {
namespace {

// The words of the command line, before their values are checked.
struct Words {
  std::string config;
  std::vector<std::string> levels;
  std::vector<std::optional<std::string>> values;  // of the options in the order of the table
  bool console = false;
  bool printConfig = false;
  bool checkConfig = false;
};

std::string helpOf(const ServerOption& option) {
  const OptionValue byDefault = valueOf(option, ServerOptions{});
  std::string help = std::string(option.help) + "; default";
  if (const auto* number = std::get_if<std::int64_t>(&byDefault)) return help + " " + std::to_string(*number);
  const auto* text = std::get_if<std::string>(&byDefault);
  return text && !text->empty() ? help + " " + *text : help + ": " + std::string(option.whenEmpty);
}

void declare(ProgramOptions& program, Words& words) {
  words.values.resize(serverOptions().size());
  for (std::size_t i = 0; i < words.values.size(); ++i) {
    const ServerOption& option = serverOptions()[i];
    if (option.name == kLevelsOption)
      program.add(std::string(option.placeholder), words.levels, helpOf(option));
    else
      program.add("--" + std::string(option.name), words.values[i], helpOf(option))
          .placeholder(std::string(option.placeholder));
  }
  program.add("--config", words.config, "Configuration file (docs/hosting.md); command-line options override it")
      .placeholder("FILE");
  auto console = program.addFlag("--console", words.console, "Give commands to the server that runs on this machine");
  auto print = program.addFlag("--print-config", words.printConfig, "Print a configuration file with all defaults");
  auto check =
      program.addFlag("--check-config", words.checkConfig, "Check the configuration and the files that it names");
  console.excludes(print).excludes(check);
  print.excludes(check);
}

CommandLine checked(const ProgramOptions& program, Words words) {
  CommandLine line;
  if (words.console) line.task = ServerTask::kConsole;
  if (words.printConfig) line.task = ServerTask::kPrintConfig;
  if (words.checkConfig) line.task = ServerTask::kCheckConfig;
  line.config = std::move(words.config);
  for (std::size_t i = 0; i < words.values.size(); ++i) {
    const ServerOption& option = serverOptions()[i];
    const bool levels = option.name == kLevelsOption && !words.levels.empty();
    if (!levels && !words.values[i]) continue;
    const auto error = levels ? setOption(option, OptionValue(words.levels), line.given)
                              : setOption(option, *words.values[i], line.given);
    if (error) program.refuse("--" + std::string(option.name) + " " + error->what);
    line.names.emplace_back(option.name);
  }
  return line;
}

}  // namespace

std::optional<CommandLine> readCommandLine(int argc, const char* const* argv) {
  ProgramOptions program("platon-server", "The dedicated server of Platon.");
  Words words;
  declare(program, words);
  if (!program.read(argc, argv)) return std::nullopt;
  return checked(program, std::move(words));
}

OptionsResult readOptions(const CommandLine& line) {
  OptionsResult result;
  if (!line.config.empty()) result.errors = readConfigFile(line.config, result.options);
  for (const ServerOption& option : serverOptions()) {
    const bool given = std::find(line.names.begin(), line.names.end(), option.name) != line.names.end();
    if (given) setOption(option, valueOf(option, line.given), result.options);
  }
  return result;
}

ServerOptions optionsOf(const CommandLine& line) {
  OptionsResult result = readOptions(line);
  if (!result.errors.empty()) throw usageError(result.errors);
  return std::move(result.options);
}

}  // namespace platon
