#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "levels/tool/check_command.h"
#include "platon_version.h"

namespace {

constexpr int kFailed = 1;
constexpr int kUsage = 2;

int run(int argc, char** argv) {
  CLI::App app("Checks Platon levels. docs/level_format.md describes the format.", "platon-level");
  app.set_version_flag("--version", "platon-level " + std::string(platon::kVersion));
  app.require_subcommand(1);

  std::vector<std::string> files;
  bool json = false;
  CLI::App* check = app.add_subcommand("check", "Print all errors and warnings of level files");
  check->add_option("FILE", files, "Level files")->required();
  check->add_flag("--json", json, "Print one JSON object to stdout");

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    std::fprintf(stderr, "platon-level: %s (see platon-level --help)\n", error.what());
    return kUsage;
  }
  return platon::checkLevels(files, json);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "platon-level: %s\n", error.what());
    return kFailed;
  }
}
