#include "client/play/match/match_play.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <span>
#include <utility>

#include "client/files/level_cache.h"
#include "client/files/server_file_name.h"
#include "client/files/user_folders.h"
#include "client/netcode/player_snapshot.h"
#include "client/session/network_client.h"
#include "client/ui/player_rows.h"

namespace platon {

namespace {

std::filesystem::path desyncFolder() {
  const std::filesystem::path folder = dataFolder();
  return folder.empty() ? folder : folder / "desyncs";
}

// What the demonstration plays is no run of the user.
std::shared_ptr<RunKeeper> runKeeper(const ClientOptions& options, const std::filesystem::path& rival) {
  using Path = std::filesystem::path;
  if (options.demo) return std::make_shared<RunKeeper>(RunStore(Path()), Path());
  const std::string server = options.server ? serverFileName(*options.server) : std::string();
  return std::make_shared<RunKeeper>(RunStore(runsFolder(), server), ghostsFolder(), rival);
}

// Empty for the embedded server: it ends with the program, so no token is stored.
std::filesystem::path sessionFolder(const ClientOptions& options) {
  const std::filesystem::path folder = dataFolder();
  return folder.empty() || !options.server ? std::filesystem::path() : folder / "sessions";
}

// The embedded server has its levels on this disk already.
std::shared_ptr<LevelStore> levelStore(const ClientOptions& options, const ServerAddress& server) {
  const std::filesystem::path folder = cacheFolder();
  if (folder.empty() || !options.server) return nullptr;
  return std::make_shared<LevelCache>(folder / "levels", server);
}

// Empty if the key of the server is known without the file: a list of servers tells new keys, too.
std::filesystem::path knownServersFile(const ClientOptions& options) {
  const std::filesystem::path folder = dataFolder();
  return folder.empty() || options.knowledge.identity ? std::filesystem::path() : folder / "known_servers";
}

ServerKnowledge knowledgeOf(const ClientOptions& options, const KnownServers& servers, const ServerAddress& server) {
  ServerKnowledge knowledge = options.knowledge;
  if (!knowledge.identity) knowledge.identity = servers.find(server);
  return knowledge;
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

}  // namespace

MatchPlay::MatchPlay(const ClientOptions& options, const ServerAddress& server, Moment now,
                     const std::filesystem::path& rival)
    : server_(server),
      ownServer_(!options.server),
      runs_(runKeeper(options, rival)),
      sessionFile_(sessionFolder(options), server),
      knownServers_(knownServersFile(options)),
      client_(server,
              {options.name, knowledgeOf(options, knownServers_, server), std::nullopt, sessionFile_.token(),
               levelStore(options, server), runs_},
              now),
      hasRival_(!rival.empty()),
      desyncFolder_(desyncFolder()),
      lines_(now) {}

void MatchPlay::update(Moment now, const Controls& controls) {
  client_.update(now, controls);
  reportDesync(now);
  reportOutage(now);
  reportRuns();
  takeNotice(now);
  takeChats(now);
  saveToken();
  rememberServer();
  lines_.update(now);
}

// `KnownServers::remember` looks into its file, so once is enough.
void MatchPlay::rememberServer() {
  if (serverRemembered_ || !client_.welcomed() || !client_.identity()) return;
  const std::string fault = knownServers_.remember(server_, *client_.identity());
  if (!fault.empty()) std::fprintf(stderr, "platon-client: %s\n", fault.c_str());
  serverRemembered_ = true;
}

void MatchPlay::reportDesync(Moment now) {
  if (const auto desync = client_.takeDesync()) lines_.add(desyncFolder_.write(*desync), now);
}

void MatchPlay::reportOutage(Moment now) {
  if (client_.outage() == reportedOutage_) return;
  reportedOutage_ = client_.outage();
  lines_.add(reportedOutage_ ? *reportedOutage_ + "; reconnecting" : "reconnected", now);
}

void MatchPlay::reportRuns() {
  for (const std::string& fault : runs_->takeFaults()) std::fprintf(stderr, "platon-client: %s\n", fault.c_str());
}

void MatchPlay::show(const Settings& settings) {
  timerShown_ = settings.timer;
  ghostsShown_ = settings.ghosts;
  chatShown_ = settings.chat;
  sceneFeed_.setOwnBall(settings.ball);
}

std::shared_ptr<const Level> MatchPlay::level() const {
  const Round* const round = client_.session() == nullptr ? nullptr : client_.session()->round();
  return round == nullptr ? nullptr : round->prediction().confirmed().sharedLevel();
}

void MatchPlay::takeChats(Moment now) {
  for (const PlayerChat& said : client_.takeChats()) {
    const std::span<const std::string> names = client_.session()->names();
    const std::string name = said.slot < names.size() ? names[said.slot] : std::string();
    chat_.add(calledName(name, std::to_string(said.slot + 1)), said.chat.text, said.chat.emote, toSeconds(now));
  }
}

void MatchPlay::takeNotice(Moment now) {
  std::optional<std::string> notice = client_.takeNotice();
  if (!notice) return;
  notice_ = std::move(*notice);
  noticeUntil_ = now + kNoticeTime;
  lines_.add("the server says: " + notice_, now);
}

void MatchPlay::saveToken() {
  if (tokenSaved_ || !client_.welcomed()) return;
  sessionFile_.keep(client_.token());
  tokenSaved_ = true;
}

std::vector<GhostSource> MatchPlay::ghosts() const {
  const Round* const round = client_.session()->round();
  if ((!ghostsShown_ && !hasRival_) || round == nullptr) return {};
  const Prediction& prediction = round->prediction();
  return runs_->ghostsAt(prediction.predicted(), prediction.slot(), round->predictedFraction());
}

// During an outage the new session's game is still empty.
std::optional<Scene> MatchPlay::scene(Moment now) {
  if (client_.outage()) return lastScene_;
  lastScene_ = client_.session() == nullptr ? std::nullopt : sceneFeed_.scene(*client_.session(), now, ghosts());
  return lastScene_;
}

std::string MatchPlay::message() const {
  if (client_.ending()) return *client_.ending();
  if (client_.outage()) return *client_.outage() + "; reconnecting …";
  if (ownServer_ && (client_.session() == nullptr || client_.session()->round() == nullptr)) return "Loading …";
  if (client_.session() == nullptr) return "connecting to " + server_.text() + " …";
  return client_.session()->round() == nullptr ? "waiting for the level …" : "";
}

std::string MatchPlay::notice(Moment now) const { return now < noticeUntil_ ? notice_ : std::string(); }

HudStatus MatchPlay::hudStatus(Moment now, bool help) const {
  HudStatus status{message(), client_.ending().has_value(), help, notice(now)};
  const Session* const session = client_.session();
  status.timer = timerShown_;
  if (session == nullptr || client_.outage()) return status;
  status.run = runs_->status();
  if (chatShown_) status.chat = chat_.lines(toSeconds(now));
  status.summary = summaryOf(*session);
  if (!status.summary) status.vote = voteOf(*session);
  return status;
}

void MatchPlay::leave(const Clock& clock) {
  // During an outage the Leave message would not arrive; the saved token can still resume the player.
  if (!client_.outage()) sessionFile_.forget();
  client_.leave();
  reportDesync(clock.now());
  lines_.tell();
  runs_->store();  // waits for the last run
  reportRuns();
  const auto update = [this](Moment now) { client_.update(now, [](const Game&, std::uint32_t) { return Input{}; }); };
  updateUntilClosed(clock, update, [this] { return client_.closed(); });
}

}  // namespace platon
