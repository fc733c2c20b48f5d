#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "levels/picture/level_picture.h"
#include "levels/tool/check_command.h"
#include "levels/tool/preview_command.h"
#include "levels/tool/solve_command.h"
#include "protocol/program_error.h"
#include "protocol/program_options.h"

namespace {

// Reads what follows --without. A checkpoint has no number: what follows it is the file.
void readWithout(const platon::ProgramOptions& program, std::vector<std::string> words, platon::SolveOptions& solving) {
  if (words.empty()) return;
  if (words.front() == "checkpoint" && words.size() > 1 && solving.file.empty()) {
    solving.file = words.back();
    words.pop_back();
  }
  const std::string word = words.front() + (words.size() > 1 ? " " + words.back() : "");
  solving.without = platon::needOf(word);
  if (!solving.without)
    program.refuse("--without must be key K or plate K with K from 0 to 31, or checkpoint, not '" + word + "'");
}

int run(int argc, char** argv) {
  using Option = platon::ProgramOptions::Option;
  platon::ProgramOptions program("platon-level",
                                 "Checks, solves and draws Platon levels. docs/level_format.md describes the format.");

  std::vector<std::string> files;
  bool json = false;
  auto check = program.addCommand("check", "Print all errors and warnings of level files");
  check.add("FILE", files, "Level files").required();
  check.addFlag("--json", json, "Print one JSON object to stdout");

  std::string level;
  std::string picture;
  int width = platon::kPictureWidth;
  auto preview = program.addCommand("preview", "Draw a level: its solid from two sides, and its net");
  preview.add("FILE", level, "Level file").required();
  preview.add("-o,--output", picture, "PNG file to write").placeholder("FILE").required();
  preview.add("--width", width, "Width of the picture in pixels; the height is 5/8 of it")
      .range(platon::kMinPictureWidth, platon::kMaxPictureWidth)
      .showDefault();

  platon::SolveOptions solving;
  auto solve = program.addCommand("solve", "Search for a way to the goal");
  solve.add("FILE", solving.file, "Level file");
  const Option output =
      solve.add("-o,--output", solving.recording, "Recording to write, of the way that was found").placeholder("FILE");
  const Option crossings = solve
                               .add("--without-crossing", solving.withoutCrossing,
                                    "Prove that every way to the goal crosses at least this many edges")
                               .range(0, 200);
  std::vector<std::string> without;
  const Option element =
      solve.add("--without", without, "Prove that every way to the goal uses this: key K, plate K or checkpoint")
          .placeholder("WORD K")
          .texts(1, 2);
  const Option pressCost =
      solve
          .add("--press-cost", solving.pressCost,
               "Count each press of a button as this many ticks: 0 finds a fast way, 30 an easy one")
          .range(0, 600)
          .showDefault();
  solve
      .add("--recorded", solving.recorded,
           "Describe the way in this recording instead of searching; fail if it does not lead to the goal")
      .placeholder("FILE")
      .excludes(output)
      .excludes(crossings)
      .excludes(element)
      .excludes(pressCost);
  solve.addFlag("--json", solving.json, "Print one JSON object to stdout");

  if (!program.read(argc, argv)) return 0;
  readWithout(program, without, solving);
  if (solve.given() && solving.file.empty()) program.refuse("solve: FILE is missing");
  if (solve.given()) return platon::solveLevel(solving);
  if (preview.given()) return platon::previewLevel(level, picture, width);
  return platon::checkLevels(files, json);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const platon::ProgramError& error) {
    std::fprintf(stderr, "platon-level: %s\n", error.what());
    return error.exitCode();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "platon-level: %s\n", error.what());
    return platon::ProgramError::kFailed;
  }
}
