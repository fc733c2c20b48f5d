#include "client/play/match/live_match.h"

#include <span>

#include "client/files/server_files.h"
#include "client/files/user_folders.h"
#include "client/lobby/near_servers.h"
#include "client/net/enet_link.h"
#include "client/netcode/player_snapshot.h"
#include "client/ui/player_rows.h"

namespace platon {
namespace {

std::filesystem::path desyncFolder() {
  const std::filesystem::path folder = dataFolder();
  return folder.empty() ? folder : folder / "desyncs";
}

// What the demonstration reaches is nothing that the user has reached.
std::filesystem::path reachedFileOf(const ClientOptions& options) {
  return options.demo ? std::filesystem::path() : reachedLevelsFile();
}

// What the demonstration plays is no run of the user.
std::shared_ptr<RunKeeper> runKeeper(const ClientOptions& options, const MatchChoice& choice) {
  using Path = std::filesystem::path;
  if (options.demo) return std::make_shared<RunKeeper>(RunStore(Path()), Path());
  const std::string server = choice.server ? serverFileName(*choice.server) : std::string();
  return std::make_shared<RunKeeper>(RunStore(runsFolder(), server), ghostsFolder(), choice.rival);
}

std::filesystem::path sessionFolder() {
  const std::filesystem::path folder = dataFolder();
  return folder.empty() ? std::filesystem::path() : folder / "sessions";
}

// The server in this program has its levels on this disk already.
std::shared_ptr<LevelStore> levelStore(const MatchChoice& choice) {
  const std::filesystem::path folder = cacheFolder();
  if (folder.empty() || !choice.server) return nullptr;
  return std::make_shared<LevelCache>(folder / "levels", *choice.server);
}

// Empty if the key of the server is known without the file: a list of servers tells new keys, too.
std::filesystem::path knownServersFile(const ServerKnowledge& knowledge) {
  const std::filesystem::path folder = dataFolder();
  return folder.empty() || knowledge.identity ? std::filesystem::path() : folder / "known_servers";
}

EmbeddedSettings ownSettings(const ClientOptions& options, const MatchChoice& choice) {
  EmbeddedSettings settings = choice.own;
  settings.stepped = options.step;
  return settings;
}

std::array<BallChoice, kMaxLocalPlayers> ballsOf(const Settings& settings) {
  return {settings.ball, settings.second.ball, settings.third.ball, settings.fourth.ball};
}

const Round* roundOf(const NetworkClient& client) {
  return client.session() == nullptr ? nullptr : client.session()->round();
}

// The player of this program in the confirmed game; null if it has none.
const PlayerState* localPlayer(const Round& round) {
  const Prediction& prediction = round.prediction();
  const Game& game = prediction.confirmed();
  return prediction.slot() < game.slots() ? &game.player(prediction.slot()) : nullptr;
}

// The next round starts when the server's game, which the confirmed one follows, has reached the end of the pause.
std::optional<RoundSummary> summaryOf(const Session& session) {
  const RoundEnd* const end = session.roundEnd();
  if (end == nullptr) return std::nullopt;
  const std::uint32_t confirmed = session.round()->prediction().confirmedTicks();
  const std::uint32_t passed = confirmed - std::min(confirmed, end->tick);
  RoundSummary summary{end->nextTitle, secondsOf(end->pauseTicks - std::min(end->pauseTicks, passed))};
  summary.waits = end->pauseTicks == 0;
  if (!end->best) return summary;
  summary.bestSeconds = secondsOf(end->best->ticks);
  summary.bestName = end->best->name;
  summary.bestIsNew = end->best->isNew;
  return summary;
}

std::optional<VoteStatus> voteOf(const Session& session) {
  const VoteCount& count = session.voteCount();
  if (count.votes == 0) return std::nullopt;
  return VoteStatus{count.votes, count.voters, session.wishesNext()};
}

void printFault(const std::string& fault) {
  if (!fault.empty()) std::fprintf(stderr, "platon-client: %s\n", fault.c_str());
}

}  // namespace

ServerMemory::ServerMemory(const MatchChoice& choice)
    : server_(*choice.server),
      given_{choice.key, choice.password},
      known_(knownServersFile(given_)),
      session_(sessionFolder(), server_) {}

ServerKnowledge ServerMemory::knowledge() const {
  ServerKnowledge knowledge = given_;
  if (!knowledge.identity) knowledge.identity = known_.find(server_);
  return knowledge;
}

// `KnownServers::remember` looks into its file, so once is enough.
void ServerMemory::keep(const NetworkClient& client) {
  if (!client.welcomed()) return;
  if (!std::exchange(tokenKept_, true)) session_.keep(client.token());
  if (keyKept_ || !client.identity()) return;
  printFault(known_.remember(server_, *client.identity()));
  keyKept_ = true;
}

LiveMatch::LiveMatch(const ClientOptions& options, const MatchChoice& choice, const Clock& clock)
    : choice_(choice),
      clock_(clock),
      time_(std::make_shared<PausableClock>(clock.now)),
      server_(choice.server ? nullptr : startServer(ownSettings(options, choice), time_)),
      memory_(choice.server ? std::make_optional<ServerMemory>(choice) : std::nullopt),
      demo_(options.demo),
      runs_(runKeeper(options, choice)),
      client_(server_ ? server_->links() : enetLinks(*choice.server),
              {options.name.empty() ? choice.name : options.name, server_ ? server_->knowledge() : memory_->knowledge(),
               memory_ ? memory_->token() : std::nullopt, levelStore(choice), runs_},
              now()),
      reached_(reachedFileOf(options)),
      lines_(now()),
      desyncFolder_(desyncFolder()) {}

void LiveMatch::update(bool wantsPause, const Controls& controls, double speed) {
  time_->setPaused(wantsPause && alone() && client_.welcomed());
  run(alone() ? speed : 1);
  exchange(now(), controls);
  report();
  noteChats();
  if (memory_) memory_->keep(client_);
  noteGoal();
}

void LiveMatch::exchange(Time now, const Controls& controls) {
  if (server_) server_->step();
  client_.update(now, controls);
  if (server_) server_->step();  // what was pressed is there in time for the next tick
}

// What counts is told before the time runs slower. What the demonstration reaches is nothing of the user.
void LiveMatch::run(double speed) {
  const Round* const round = roundOf(client_);
  const PlayerState* const player = round == nullptr ? nullptr : localPlayer(*round);
  if (player != nullptr) attempt_.observe(round->id(), *player, speed);
  const bool counts = speed == 1 && !demo_;
  if (server_) server_->countTimes(counts);
  if (server_) server_->keepTimesOf(slots());
  runs_->countRuns(counts);
  time_->setSpeed(speed);
}

// Also an attempt whose time does not count has reached the goal, and any player of this machine reaches it for all.
void LiveMatch::noteGoal() {
  const Round* const round = roundOf(client_);
  if (!alone() || round == nullptr) return;
  const Game& game = round->prediction().confirmed();
  for (const std::optional<std::uint32_t>& slot : round->prediction().slots()) {
    if (slot && *slot < game.slots() && game.player(*slot).arrived != 0)
      return printFault(reached_.add(game.level().hash));
  }
}

void LiveMatch::report() {
  if (const auto desync = client_.takeDesync()) lines_.add(desyncFolder_.write(*desync), now());
  if (client_.outage() != reportedOutage_) {
    reportedOutage_ = client_.outage();
    lines_.add(reportedOutage_ ? *reportedOutage_ + "; reconnecting" : "reconnected", now());
  }
  if (std::optional<std::string> notice = client_.takeNotice()) {
    notice_ = {std::move(*notice), now() + kNoticeTime};
    lines_.add("the server says: " + notice_.text, now());
  }
  reportRuns();
  lines_.update(now());
}

void LiveMatch::reportRuns() {
  for (const std::string& fault : runs_->takeFaults()) printFault(fault);
}

void LiveMatch::noteChats() {
  for (const PlayerChat& said : client_.takeChats()) {
    const std::span<const std::string> names = client_.session()->names();
    const std::string name = said.slot < names.size() ? names[said.slot] : std::string();
    chat_.add(calledName(name, std::to_string(said.slot + 1)), said.chat.text, said.chat.emote, toSeconds(now()));
    bubbles_.add(said.slot, said.chat.emote, toSeconds(now()));
  }
}

void LiveMatch::skipLevel() {
  if (!alone()) return client_.toggleVote();
  const Round* const round = roundOf(client_);
  const std::uint32_t present = round == nullptr ? 0 : round->id();
  if (asked_ != present) server_->startNextLevel();  // it takes a while; a second press would skip the level after it
  asked_ = present;
}

void LiveMatch::leave() {
  time_->setPaused(false);
  time_->setSpeed(1);
  // During an outage the Leave message would not arrive; the saved token can still resume the player.
  if (memory_ && !client_.outage()) memory_->forgetToken();
  client_.leave();
  if (const auto desync = client_.takeDesync()) lines_.add(desyncFolder_.write(*desync), now());
  lines_.tell();
  runs_->store();  // waits for the last run
  reportRuns();
  const Time pauses = clock_.now() - now();
  const Clock clock{[this] { return now(); }, [this, pauses](Time until) { clock_.sleepUntil(until + pauses); }};
  const auto update = [this](Time now) { exchange(now, [](const Game&, std::uint32_t) { return Input{}; }); };
  updateUntilClosed(clock, update, [this] { return client_.closed(); });
}

std::shared_ptr<const Level> LiveMatch::level() const {
  const Round* const round = roundOf(client_);
  return round == nullptr ? nullptr : round->prediction().confirmed().sharedLevel();
}

// Too few players never finish a level for several, so it may be left without a question.
bool LiveMatch::losesNothing() const {
  const SlotsByLocal players = slots();
  const auto count = std::count_if(players.begin(), players.end(), [](const auto& slot) { return slot.has_value(); });
  return roundOver() || (level() && level()->players > count);
}

std::vector<GhostSource> LiveMatch::ghosts(const Settings& settings) const {
  const Round* const round = roundOf(client_);
  if ((!settings.ghosts && choice_.rival.empty()) || round == nullptr) return {};
  const Prediction& prediction = round->prediction();
  return runs_->ghostsAt(prediction.predicted(), prediction.slot(), round->predictedFraction());
}

// During an outage the new session's game is still empty.
std::optional<Scene> LiveMatch::scene(const Settings& settings, std::size_t local) {
  std::optional<Scene>& last = lastScenes_[local];
  if (client_.outage()) return last;
  last.reset();
  if (!slots()[local]) return last;
  last = sceneFeed_.scene(*client_.session(), now(), {local, !waits(), ballsOf(settings), ghosts(settings)});
  if (!last || !settings.chat) return last;
  for (PlayerDrawing& player : last->players) player.says = bubbles_.of(player.slot, toSeconds(now()));
  return last;
}

SlotsByLocal LiveMatch::slots() const {
  const Round* const round = roundOf(client_);
  return round == nullptr ? SlotsByLocal() : round->prediction().slots();
}

std::string LiveMatch::message() const {
  if (client_.ending()) return *client_.ending();
  if (client_.outage()) return *client_.outage() + "; reconnecting …";
  if (server_ && roundOf(client_) == nullptr) return "Loading …";
  if (client_.session() == nullptr) return "connecting to " + choice_.server->text() + " …";
  return roundOf(client_) == nullptr ? "waiting for the level …" : "";
}

HudStatus LiveMatch::hudStatus(const Settings& settings, bool help) const {
  const std::string notice = now() < notice_.until ? notice_.text : std::string();
  HudStatus status{message(), client_.ending().has_value(), help, notice};
  status.timer = settings.timer;
  const Session* const session = client_.session();
  if (session != nullptr && !client_.outage()) {
    status.run = runs_->status();
    if (settings.chat) status.chat = chat_.lines(toSeconds(now()));
    status.summary = summaryOf(*session);
    if (!status.summary) status.vote = voteOf(*session);
  }
  status.run.speed = leastSpeed();
  return status;
}

std::vector<std::string> LiveMatch::said(const Settings& settings) const {
  return settings.chat ? chat_.newest() : std::vector<std::string>();
}

std::vector<std::string> LiveMatch::invitation() const {
  if (!server_ || !server_->port()) return {};
  std::string addresses;
  for (const std::string& host : ownAddresses()) {
    addresses += (addresses.empty() ? "" : " or ") + ServerAddress{host, *server_->port()}.text();
  }
  if (addresses.empty()) return {"This machine has no network."};
  return {"Others join at " + addresses};
}

}  // namespace platon
