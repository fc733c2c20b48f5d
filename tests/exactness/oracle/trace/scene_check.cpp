#include <charconv>
#include <iostream>
#include <optional>
#include <string_view>

#include "tests/exactness/oracle/trace/random_scene.h"
#include "tests/exactness/oracle/trace/traced_run.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon::oracle {
namespace {

/// The largest speed is scale / 8 times a power of two of up to this exponent.
constexpr std::int64_t kSpeedRange = 6;

std::vector<std::string> command(const std::string& program, const std::string& file, std::int64_t ticks,
                                 std::uint64_t seed, std::int64_t speed) {
  return {program,
          "world",
          file,
          "--ticks",
          std::to_string(ticks),
          "--seed",
          std::to_string(seed),
          "--max-speed",
          std::to_string(speed),
          "--json"};
}

/// Totals over all scenes.
struct Totals {
  std::int64_t legs = 0;
  std::int64_t playerTicks = 0;
  std::int64_t failures = 0;
};

/// Prints the scene if a check fails.
void checkScene(const std::string& program, const std::string& file, std::int64_t ticks, std::uint64_t seed,
                Totals& totals) {
  RandomSource random(seed);
  const Scene scene = randomScene(random);
  const std::int64_t speed = std::max<std::int64_t>(1, (scene.scale / 8) << random.between(0, kSpeedRange));
  writeText(file, toText(scene));
  const auto [report, exitCode] = runTraced(command(program, file, ticks, seed, speed));
  totals.legs += report.legs;
  totals.playerTicks += report.playerTicks;
  if (report.clean() && exitCode == 0 && report.ticks == ticks) return;
  ++totals.failures;
  std::cout << "seed " << seed << ", speed up to " << speed << ", exit " << exitCode << ": " << report << '\n'
            << toText(scene) << std::flush;
}

int check(const std::string& program, std::uint64_t scenes, std::int64_t ticks, std::uint64_t firstSeed) {
  const TemporaryFolder folder;
  Totals totals;
  for (std::uint64_t i = 0; i < scenes; ++i) checkScene(program, folder / "scene", ticks, firstSeed + i, totals);
  std::cout << scenes << " scenes from seed " << firstSeed << ", " << ticks << " ticks each: " << totals.playerTicks
            << " entity ticks, " << totals.legs << " legs, " << totals.failures << " failures\n";
  return totals.failures == 0 ? 0 : 1;
}

std::optional<std::int64_t> parse(std::string_view text) {
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool whole = error == std::errc{} && end == text.data() + text.size() && number > 0;
  return whole ? std::optional(number) : std::nullopt;
}

}  // namespace
}  // namespace platon::oracle

int main(int count, char** arguments) {
  using namespace platon::oracle;
  const auto scenes = count == 5 ? parse(arguments[2]) : std::nullopt;
  const auto ticks = count == 5 ? parse(arguments[3]) : std::nullopt;
  const auto seed = count == 5 ? parse(arguments[4]) : std::nullopt;
  if (!scenes || !ticks || !seed) {
    std::cerr << "usage: platon-scene-check PLATON-SIM SCENES TICKS SEED\n";
    return 2;
  }
  try {
    return check(arguments[1], static_cast<std::uint64_t>(*scenes), *ticks, static_cast<std::uint64_t>(*seed));
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
