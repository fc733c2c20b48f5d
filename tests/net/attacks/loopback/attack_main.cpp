// platon-attack: attacks a server on this machine; see usage below. `./platon bench --attacks` runs it.
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <exception>
#include <optional>
#include <string>
#include <thread>

#include "client/time/steady_now.h"
#include "tests/net/attacks/attack.h"
#include "tests/net/attacks/loopback/loopback_attack_network.h"

// Last, because RefusalReason has a kVersion too, and GCC warns of the second.
#include "platon_version.h"

namespace platon {
namespace {

constexpr const char* kUsage =
    "usage: platon-attack PORT ATTACK --seconds S [--rate N]\n"
    "       platon-attack --list\n"
    "\n"
    "Attacks the server at 127.0.0.1:PORT, from other addresses of 127.0.0.0/8, with N datagrams a second (20000 by\n"
    "default). Attacks over IPv6 go from fd00::/16 to [::1]:PORT. Prints `relay ADDRESS`, through which honest "
    "players\n"
    "join, and attacks for S seconds after a line on standard input; for 30 if it amplifies. Then it prints one JSON\n"
    "object, and relays until standard input ends. The attack `none` sends nothing. --list prints all attacks, one "
    "JSON\n"
    "object a line.\n";

constexpr int kFailed = 1;
constexpr int kUsageError = 2;
constexpr Time kPumpInterval = std::chrono::microseconds(250);
constexpr Time kStep = std::chrono::milliseconds(1);
constexpr int kMaxStepsAtOnce = 20;  // after a pause of this process; what was missed beyond it is not made up

struct Options {
  std::uint16_t port = 0;
  const Attack* attack = nullptr;  // null: none
  int seconds = 0;
  int rate = 20000;
};

std::optional<int> numberOf(const char* text, int most) {
  int number = 0;
  const char* const end = text + std::strlen(text);
  const auto [stop, error] = std::from_chars(text, end, number);
  if (error != std::errc() || stop != end || number < 1 || number > most) return std::nullopt;
  return number;
}

const Attack* attackOf(std::string_view name) {
  const auto all = attacks();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Attack& each) { return each.name == name; });
  return found == all.end() ? nullptr : &*found;
}

// Nothing if the arguments are wrong.
std::optional<Options> readOptions(int argc, char** argv) {
  if (argc != 5 && argc != 7) return std::nullopt;
  Options options;
  options.attack = attackOf(argv[2]);
  const std::optional<int> port = numberOf(argv[1], UINT16_MAX);
  if (!port || (options.attack == nullptr && std::strcmp(argv[2], "none") != 0)) return std::nullopt;
  options.port = static_cast<std::uint16_t>(*port);
  for (int i = 3; i < argc; i += 2) {
    const std::string_view option = argv[i];
    const std::optional<int> value = numberOf(argv[i + 1], 1000000);
    if (!value || (option != "--seconds" && option != "--rate")) return std::nullopt;
    (option == "--seconds" ? options.seconds : options.rate) = *value;
  }
  if (options.seconds == 0) return std::nullopt;
  return options;
}

// Nothing: nothing to read. Otherwise whether a line has come; false: the end.
std::optional<bool> readLine() {
  pollfd input{STDIN_FILENO, POLLIN, 0};
  if (poll(&input, 1, 0) == 0) return std::nullopt;
  char bytes[64];
  return read(STDIN_FILENO, bytes, sizeof bytes) > 0;
}

/// One run of the program.
class Run {
 public:
  explicit Run(const Options& options)
      : options_(options), network_({serverAddress(versionOf(options)), options.port}) {}

  int run() {
    std::printf("relay %s\n", network_.relay().text().c_str());
    std::fflush(stdout);
    if (!waitForInput()) return 0;
    attack();
    const Exchange& all = network_.exchange();
    const Exchange late = all - early_;
    std::printf(
        "{\"sent\":%llu,\"sentBytes\":%llu,\"answeredBytes\":%llu,\"lateSentBytes\":%llu,\"lateReceivedBytes\":%llu}\n",
        number(network_.sent()), number(all.sent), number(network_.answeredBytes()), number(late.sent),
        number(late.received - late.ticks));
    std::fflush(stdout);
    while (waitForInput()) {
    }
    return 0;
  }

 private:
  static IpVersion versionOf(const Options& options) {
    return options.attack == nullptr ? IpVersion::kIpv4 : options.attack->version;
  }
  static unsigned long long number(std::uint64_t value) { return value; }

  // Relays until a line comes. False: the input has ended.
  bool waitForInput() {
    for (;;) {
      if (const std::optional<bool> line = readLine()) return *line;
      pump();
    }
  }

  void attack() {
    const std::unique_ptr<Attacker> attacker = options_.attack == nullptr ? nullptr : options_.attack->start(network_);
    const bool amplifies = options_.attack != nullptr && options_.attack->amplifies;
    attack(attacker.get(), amplifies ? kAmplifyingBegins : std::chrono::seconds(options_.seconds));
    early_ = network_.exchange();
    if (amplifies) attack(attacker.get(), kAmplifyingLasts);
  }

  void attack(Attacker* attacker, Time duration) {
    const Time begun = clock_.now();
    const auto perStep = static_cast<int>(options_.rate * kStep / std::chrono::seconds(1));
    Time stepped = begun;
    for (Time now = begun; now - begun < duration; now = clock_.now()) {
      stepped = std::max(stepped, now - kMaxStepsAtOnce * kStep);
      for (; stepped < now && attacker != nullptr; stepped += kStep) attacker->step(now, perStep);
      pump();
    }
  }

  void pump() {
    network_.pump();
    clock_.sleepUntil(clock_.now() + kPumpInterval);
  }

  Options options_;
  LoopbackAttackNetwork network_;
  Exchange early_;  // before an amplifying attack is measured
  Clock clock_ = steadyClock();
};

const char* word(bool value) { return value ? "true" : "false"; }

int list() {
  for (const Attack& attack : attacks()) {
    std::printf("{\"name\":\"%s\",\"does\":\"%s\",\"proves\":%s,\"ipv6\":%s,\"amplifies\":%s}\n",
                std::string(attack.name).c_str(), std::string(attack.does).c_str(), word(attack.proves),
                word(attack.version == IpVersion::kIpv6), word(attack.amplifies));
  }
  return 0;
}

int main(int argc, char** argv) {
  if (argc == 2 && std::strcmp(argv[1], "--list") == 0) return list();
  const bool help = argc == 2 && std::strcmp(argv[1], "--help") == 0;
  if (argc == 2 && std::strcmp(argv[1], "--version") == 0) {
    std::printf("platon-attack %s\n", std::string(kVersion).c_str());
    return 0;
  }
  const std::optional<Options> options = readOptions(argc, argv);
  if (options) return Run(*options).run();
  std::fputs(kUsage, help ? stdout : stderr);
  return help ? 0 : kUsageError;
}

}  // namespace
}  // namespace platon

int main(int argc, char** argv) {
  try {
    return platon::main(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "platon-attack: %s\n", error.what());
    return platon::kFailed;
  }
}
