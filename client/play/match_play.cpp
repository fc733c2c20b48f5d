#include "client/play/match_play.h"

#include <chrono>
#include <cstdio>
#include <filesystem>

#include "client/play/user_folders.h"

namespace platon {

namespace {

constexpr Moment kFarewell = std::chrono::milliseconds(500);
constexpr Moment kBeat = std::chrono::milliseconds(2);

std::filesystem::path desyncFolder() {
  const std::filesystem::path folder = dataFolder();
  return folder.empty() ? folder : folder / "desyncs";
}

// A server of one's own ends with the program.
std::filesystem::path sessionFolder(const ClientOptions& options) {
  const std::filesystem::path folder = dataFolder();
  return folder.empty() || !options.server ? std::filesystem::path() : folder / "sessions";
}

}  // namespace

MatchPlay::MatchPlay(const ClientOptions& options, const ServerAddress& server, Moment now)
    : server_(server),
      sessionFile_(sessionFolder(options), server),
      client_(server, options.name, options.line, options.lineSeed, now, sessionFile_.token()),
      desyncs_(desyncFolder()) {}

void MatchPlay::update(Moment now, const Controls& controls) {
  client_.update(now, controls);
  reportDesync();
  reportOutage();
  keepToken();
  if (client_->session() == nullptr) return;
  const std::optional<std::string> line = watch_.look(*client_->session());
  if (!line) return;
  std::printf("%s\n", line->c_str());
  std::fflush(stdout);
}

void MatchPlay::reportDesync() {
  const auto desync = client_->takeDesync();
  if (desync) std::fprintf(stderr, "platon-client: %s\n", desyncs_.keep(*desync).c_str());
}

void MatchPlay::reportOutage() {
  if (client_->outage() == toldOutage_) return;
  toldOutage_ = client_->outage();
  if (toldOutage_)
    std::fprintf(stderr, "platon-client: %s; trying again\n", toldOutage_->c_str());
  else
    std::fprintf(stderr, "platon-client: connected again\n");
}

void MatchPlay::keepToken() {
  if (tokenKept_ || !client_->welcomed()) return;
  sessionFile_.keep(client_->token());
  tokenKept_ = true;
}

// A session that has only just begun anew has an empty game.
std::optional<Scene> MatchPlay::scene(Moment now) {
  if (client_->outage()) return lastScene_;
  lastScene_ = client_->session() == nullptr ? std::nullopt : feed_.scene(*client_->session(), now);
  return lastScene_;
}

std::string MatchPlay::message() const {
  if (client_->ending()) return *client_->ending();
  if (client_->outage()) return *client_->outage() + "; trying again …";
  if (client_->session() == nullptr) return "connecting to " + server_.text() + " …";
  return client_->session()->round() == nullptr ? "waiting for the level …" : "";
}

void MatchPlay::leave(const Clock& clock) {
  // During an outage the server hears nothing of it, and the player can still be taken up.
  if (!client_->outage()) sessionFile_.forget();
  client_->leave();
  reportDesync();
  const Controls nothing = [](const Game&, std::uint32_t) { return Input{}; };
  const Moment end = clock.now() + kFarewell;
  for (Moment now = clock.now(); !client_->closed() && now < end; now = clock.now()) {
    client_.update(now, nothing);
    clock.sleepUntil(now + kBeat);
  }
}

}  // namespace platon
