#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "levels/picture/level_picture.h"
#include "levels/tool/check_command.h"
#include "levels/tool/exit_code.h"
#include "levels/tool/preview_command.h"
#include "levels/tool/solve_command.h"
#include "platon_version.h"

namespace {

int run(int argc, char** argv) {
  CLI::App app("Checks, solves and draws Platon levels. docs/level_format.md describes the format.", "platon-level");
  app.set_version_flag("--version", "platon-level " + std::string(platon::kVersion));
  app.require_subcommand(1);

  std::vector<std::string> files;
  bool json = false;
  CLI::App* check = app.add_subcommand("check", "Print all errors and warnings of level files");
  check->add_option("FILE", files, "Level files")->required();
  check->add_flag("--json", json, "Print one JSON object to stdout");

  std::string level;
  std::string picture;
  int width = platon::kPictureWidth;
  CLI::App* preview = app.add_subcommand("preview", "Draw a level: its solid from two sides, and its net");
  preview->add_option("FILE", level, "Level file")->required();
  preview->add_option("-o,--output", picture, "PNG file to write")->type_name("FILE")->required();
  preview->add_option("--width", width, "Width of the picture in pixels; the height is 5/8 of it")
      ->check(CLI::Range(platon::kMinPictureWidth, platon::kMaxPictureWidth))
      ->capture_default_str();

  platon::SolveOptions solving;
  CLI::App* solve = app.add_subcommand("solve", "Search for a way to the goal");
  solve->add_option("FILE", solving.file, "Level file")->required();
  solve->add_option("-o,--output", solving.recording, "Recording of the way to write")->type_name("FILE");
  solve
      ->add_option("--without-crossing", solving.withoutCrossing,
                   "Prove that no way to the goal has fewer than this many crossings of edges")
      ->check(CLI::Range(0, 200));
  solve
      ->add_option("--press-cost", solving.pressCost,
                   "Count each press of a button as so many ticks: 0 finds a fast way, 30 an easy one")
      ->check(CLI::Range(0, 600))
      ->capture_default_str();
  CLI::Option* recorded =
      solve
          ->add_option(
              "--recorded", solving.recorded,
              "Tell about the way in this recording instead of searching; fails if it does not lead to the goal")
          ->type_name("FILE");
  for (const char* search : {"--output", "--without-crossing", "--press-cost"}) {
    recorded->excludes(solve->get_option(search));
  }
  solve->add_flag("--json", solving.json, "Print one JSON object to stdout");

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    std::fprintf(stderr, "platon-level: %s (see platon-level --help)\n", error.what());
    return platon::kUsage;
  }
  if (solve->parsed()) return platon::solveLevel(solving);
  if (preview->parsed()) return platon::previewLevel(level, picture, width);
  return platon::checkLevels(files, json);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "platon-level: %s\n", error.what());
    return platon::kFailed;
  }
}
