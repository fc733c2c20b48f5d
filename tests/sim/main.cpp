#include <cstdio>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "platon_version.h"
#include "tests/sim/commands.h"
#include "tests/sim/report.h"
#include "tests/sim/sim_options.h"

namespace {

constexpr std::string_view kHelp = R"(platon-sim: runs the simulation without server, client or clock.

  platon-sim run LEVEL [--players N] [--ticks T] [--seed S] [--drive play|churn|fling|push] [--max-speed U]
                       [--velocity VX,VY] [--record FILE [--checkpoint-every TICKS]] [--trace FILE] [--json]
      Runs a level.
      --drive play    seeded button presses (default)
      --drive churn   like play; players also restart, leave and join
      --drive fling   no game rules: every tick each entity gets a random velocity of up to U subunits per tick
      --drive push    no game rules: every tick each entity gets the velocity VX,VY in its own frame
      --record FILE   writes a recording (play and churn only) with a checkpoint every 60 ticks, or every TICKS
      --trace FILE    writes every leg of every step as JSON lines
  platon-sim verify FILE [--from TICK] [--record FILE [--checkpoint-every TICKS]] [--json]
      Replays a recording from its start, or from the last checkpoint before TICK, and compares every hash and
      checkpoint. Reports the first difference by tick, entity and field, and whether the recording is a run. --record
      writes the replayed game to a new file. On a terminal a long one tells how far it is; Ctrl-C ends it.
  platon-sim verify FILE|FOLDER... --jobs N [--json]
      Replays many recordings, those of a server or a fleet, with N threads. A folder stands for all files NAME.recording
      in it and in its folders. Says what is wrong with which, how many agree, and how fast it was. Leaves out what a
      server is still writing. --jobs 1 can be left out for a folder or several files.
  platon-sim world SCENE --ticks T [--seed S --max-speed U] [--trace FILE] [--json]
      Runs a scene file, without the game rules. With --max-speed, velocities are random instead of the scene's.
  platon-sim sweep
      Reads one query a line from standard input: m x1 y1 ... xm ym  px py  vx vy  ax ay bx by
      Prints one answer a line: miss, or hit N D nx ny
  platon-sim --help | --version

Exit codes: 0 ok, 1 failed or the replay differs, 2 usage, 3 invalid level, recording or scene.
)";

int dispatch(const std::vector<std::string>& arguments) {
  using namespace platon::sim;
  const std::map<std::string, int (*)(const std::vector<std::string>&)> commands{
      {"run", runCommand}, {"verify", verifyCommand}, {"world", worldCommand}, {"sweep", sweepCommand}};
  if (arguments.empty()) throw UsageError("no command given (see platon-sim --help)");
  for (const std::string& argument : arguments) {
    if (argument == "--help") return std::fputs(kHelp.data(), stdout), 0;
    if (argument == "--version") return std::printf("platon-sim %s\n", platon::kVersion.data()), 0;
  }
  const auto command = commands.find(arguments.front());
  if (command == commands.end()) {
    throw UsageError("unknown command '" + arguments.front() + "' (see platon-sim --help)");
  }
  return command->second({arguments.begin() + 1, arguments.end()});
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return dispatch({argv + 1, argv + argc});
  } catch (const platon::sim::UsageError& reason) {
    return platon::sim::report(reason);
  } catch (const platon::sim::InputError& reason) {
    return platon::sim::report(reason);
  }
}
