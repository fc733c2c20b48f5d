#include "server/program/server_program.h"

#include <cstdlib>
#include <exception>
#include <sstream>
#include <utility>
#include <vector>

#include "protocol/program_error.h"
#include "protocol/transport/server_identity.h"
#include "server/admin/bans.h"
#include "server/app/identity_file.h"
#include "server/app/level_files.h"
#include "server/fleet/agones_call.h"
#include "server/program/options.h"
#include "server/program/server_metrics.h"

namespace platon {
namespace {

// Longest sleep without players while a console or a request for metrics is connected.
constexpr std::chrono::milliseconds kWatchedWait{10};
// While none is connected, the server looks for new ones in the first step after this time.
constexpr std::chrono::milliseconds kNoticeTime{50};

constexpr const char* kBansRemedy = "; make room on the disk, and let the server write to the folder of the file";
constexpr const char* kLostBansRemedy =
    "; make room on the disk, let the server write to the folder of the file, and add what is missing from it";

ServerSettings settingsOf(const ServerOptions& options, Log& log) {
  ServerSettings settings;
  settings.bind = options.bind;
  settings.port = options.port;
  settings.playersPerAddress = options.maxPerAddress;
  settings.match.chat = options.chat == "on";
  settings.identity = loadIdentity(options.keyFile, log);
  if (!options.passwordFile.empty()) settings.password = readPasswordFile(options.passwordFile);
  settings.match.maxPlayers = options.maxPlayers;
  settings.match.serverName = options.name;
  settings.recordings = options.record;
  settings.bestTimes = options.bestTimes;
  settings.recordLimit = *parseByteSize(options.recordLimit);
  return settings;
}

std::vector<std::string> levelFilesOf(const ServerOptions& options) {
  return options.levels.empty() ? shippedLevelFiles() : options.levels;
}

std::vector<LevelPointer> load(const std::vector<std::string>& files, Log& log) {
  LoadedLevels loaded = loadLevelFiles(files);
  for (const std::string& warning : loaded.warnings) log.warning(warning);
  return std::move(loaded.levels);
}

void warnOf(const std::exception& error, Log& log) {
  std::istringstream errors(error.what());
  for (std::string line; std::getline(errors, line);) log.warning(line);
}

BanList readBans(const std::string& path) {
  if (path.empty()) return {};
  auto read = readBanFile(path);
  if (auto* list = std::get_if<BanList>(&read)) return std::move(*list);
  throw usageError(std::get<std::vector<std::string>>(read));
}

BanStore banStoreOf(const std::string& path) { return path.empty() ? BanStore() : BanStore(path, readBans(path)); }

std::unique_ptr<MetricsServer> metricsServerOf(const std::string& address) {
  return address.empty() ? nullptr : std::make_unique<MetricsServer>(*parseSocketAddress(address));
}

}  // namespace

ServerProgram::ServerProgram(const CommandLine& line, const ServerOptions& options, const LogSink& sink)
    : ServerProgram(line, options, Log(options.logFormat, sink)) {}

ServerProgram::ServerProgram(const CommandLine& line, const ServerOptions& options, Log log)
    : line_(line),
      options_(options),
      bans_(banStoreOf(options.banFile)),
      levelFiles_(levelFilesOf(options)),
      server_(settingsOf(options, log), load(levelFiles_.files(), log), log),
      agones_(agonesPortOf(std::getenv(kAgonesPortVariable)), steadyNow),
      announcement_(announcementOf(options.announce, options.announceAs, server_.identity())),
      console_(server_.match(), bans_, consoleProgram()),
      metricsServer_(metricsServerOf(options.metrics)),
      startedAt_(steadyNow()) {
  server_.refuseBanned(bans_.list());
  openConsole();
}

void ServerProgram::openConsole() {
  if (!options_.socket.empty()) {
    consoleServer_ = std::make_unique<ConsoleServer>(options_.socket);
    return;
  }
  try {
    consoleServer_ = std::make_unique<ConsoleServer>(defaultConsolePath());
  } catch (const ProgramError& error) {
    whyNoConsole_ = error.what();
  }
}

ConsoleProgram ServerProgram::consoleProgram() {
  return {[this] { return status(); }, [this] { return reload(); }, [this] { stopping_ = true; },
          [this](const DrainCommand& command) { return drain(command); },
          [this](std::string_view line) {
            server_.log().info("console", {{"command", std::string(line)}});
          }};
}

void ServerProgram::announce() {
  Log& log = server_.log();
  log.info("listening on " + server_.address().text());
  if (consoleServer_)
    log.info("console on " + consoleServer_->path());
  else
    log.warning("no console: " + whyNoConsole_);
  if (metricsServer_) log.info("metrics on " + metricsServer_->address().text());
  enterList();
}

void ServerProgram::enterList() {
  if (announcement_) announcement_->enter(options_.name);
}

void ServerProgram::leaveList() {
  if (announcement_) announcement_->leave();
}

void ServerProgram::logList(const std::optional<Announcement::Outcome>& outcome) {
  if (!outcome) return;
  const LogField file{"file", options_.announce};
  if (!outcome->fault.empty()) {
    const char* const what = outcome->enters ? "not announced" : "not taken out of the list of servers";
    server_.log().warning(what, {file, {"reason", outcome->fault}});
  } else if (outcome->enters) {
    server_.log().info("announced", {file, {"address", options_.announceAs}});
  }
}

bool ServerProgram::run(const std::function<bool()>& stopRequested) {
  agones_.start(server_.log());
  serviceManager_.ready();
  server_.run([&] {
    const TimePoint now = steadyNow();
    serviceManager_.alive(now, drain_.begun());
    agones_.report(server_.match(), server_.log());
    if (now >= nextPollAt_) pollTools();
    pollLevels(now);
    const bool stops = stopRequested() || stopping_ || hasDrained(now);
    if (stops) serviceManager_.stopping();
    return stops;
  });
  leaveList();
  if (announcement_) logList(announcement_->finish());
  const auto lost = bans_.finish();
  if (lost)
    server_.log().warning("bans lost", {{"file", options_.banFile}, {"reason", *lost + kLostBansRemedy}});
  else
    logBans(std::nullopt);
  agones_.finish(server_.log());
  return !lost;
}

void ServerProgram::terminate() {
  if (options_.drain == 0 || drain_.begun())
    stopping_ = true;
  else
    drain({});
}

ConsoleReply ServerProgram::drain(const DrainCommand& command) {
  const std::chrono::seconds limit = command.limit.value_or(std::chrono::seconds(options_.drain));
  if (limit.count() == 0) return {false, "name the longest time in seconds, as in 'drain 600'"};
  const std::string& next = command.next.empty() ? options_.drainTo : command.next;
  drain_.begin(steadyNow(), limit, next);
  server_.setNextServer(next);
  leaveList();
  std::vector<LogField> fields{{"seconds", std::uint64_t(limit.count())}};
  if (!next.empty()) fields.push_back({"next", next});
  server_.log().info("draining", fields);
  return {true, "the server stops after this round, at the latest in " + std::to_string(limit.count()) + " s"};
}

bool ServerProgram::hasDrained(TimePoint now) {
  const auto cause = drain_.over(now);
  if (cause) server_.log().info("drained", {{"cause", std::string(*cause)}});
  return cause.has_value();
}

// Logs why the bans could not be written, and the end of such a failure.
void ServerProgram::logBans(const std::optional<std::string>& fault) {
  const LogField file{"file", options_.banFile};
  if (fault) {
    bansUnwritten_ = true;
    server_.log().warning("bans not written", {file, {"reason", *fault + kBansRemedy}});
  } else if (bansUnwritten_ && !bans_.pending()) {
    bansUnwritten_ = false;
    server_.log().info("bans written", {file});
  }
}

void ServerProgram::pollTools() {
  const TimePoint now = steadyNow();
  if (consoleServer_) {
    consoleServer_->poll(now, [this](std::string_view line) { return console_.execute(line, utcNow()); });
  }
  if (metricsServer_) metricsServer_->poll(now, [this] { return metricsText(); });
  logBans(bans_.poll(now));
  if (announcement_) logList(announcement_->poll(now));
  const bool watched =
      (consoleServer_ && consoleServer_->consoles() > 0) || (metricsServer_ && metricsServer_->connections() > 0);
  server_.setIdleWait(watched ? kWatchedWait : DedicatedServer::kIdleWait);
  nextPollAt_ = watched ? now : now + kNoticeTime;
}

ConsoleReply ServerProgram::reload() {
  serviceManager_.reloading(steadyNow());
  ConsoleReply reply = readAgain();
  serviceManager_.ready();
  return reply;
}

ConsoleReply ServerProgram::readAgain() {
  Log& log = server_.log();
  try {
    const ServerOptions fresh = optionsOf(line_);
    FileWatch levelFiles(levelFilesOf(fresh));
    std::vector<LevelPointer> levels = load(levelFiles.files(), log);
    if (const auto error = bans_.replace(readBans(options_.banFile))) {
      throw ProgramError(ProgramError::kUsage, error->what);
    }
    levelFiles_ = std::move(levelFiles);
    server_.setLevels(std::move(levels));
    const std::string later = takeOver(fresh);
    enforceBans(server_.match(), bans_.list(), utcNow());
    const std::string done = "configuration and levels reloaded" + later;
    log.info(done);
    return {true, done};
  } catch (const std::exception& error) {
    warnOf(error, log);
    const std::string failed = "configuration and levels not reloaded";
    log.warning(failed);
    return {false, error.what() + ("\n" + failed)};
  }
}

void ServerProgram::pollLevels(TimePoint now) {
  if (!levelFiles_.poll(now)) return;
  Log& log = server_.log();
  try {
    server_.updateLevels(load(levelFiles_.files(), log));
    log.info("levels reloaded");
  } catch (const std::exception& error) {
    warnOf(error, log);
    log.warning("levels not reloaded");
  }
}

// Returns which changed options wait for a restart.
std::string ServerProgram::takeOver(const ServerOptions& fresh) {
  std::string waiting;
  for (const ServerOption& option : serverOptions()) {
    const OptionValue value = valueOf(option, fresh);
    if (!option.needsRestart)
      setOption(option, value, options_);
    else if (value != valueOf(option, options_))
      waiting += (waiting.empty() ? "; restart the server to change " : ", ") + std::string(option.name);
  }
  server_.setName(options_.name);
  if (!drain_.begun()) enterList();
  server_.log().setFormat(options_.logFormat);
  return waiting;
}

std::string ServerProgram::status() const {
  const auto uptime = std::chrono::duration_cast<std::chrono::seconds>(steadyNow() - startedAt_);
  const TickTimes recent = server_.recentTickTimes();
  std::ostringstream text;
  text << "server: " << options_.name << "\naddress: " << server_.address().text() << "\nuptime: " << uptime.count()
       << " s\nticks: " << server_.tickTimes().count() << ", p50 " << recent.quantile(0.5) << " µs, p99 "
       << recent.quantile(0.99) << " µs, longest " << recent.longest() << " µs";
  if (drain_.begun()) text << "\ndraining: at most " << drain_.secondsLeft(steadyNow()).count() << " s more";
  return text.str();
}

std::optional<SocketAddress> ServerProgram::metricsAddress() const {
  return metricsServer_ ? std::optional(metricsServer_->address()) : std::nullopt;
}

std::string ServerProgram::metricsText() const {
  return formatMetrics(metricsOf(server_, {.startedAt = startTime_,
                                           .serverName = options_.name,
                                           .maxPlayers = options_.maxPlayers,
                                           .bans = bans_.list().size(),
                                           .unwrittenBans = bans_.failures()}));
}

}  // namespace platon
