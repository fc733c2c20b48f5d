#include "tests/net/support/fake_client.h"

#include <gtest/gtest.h>

#include <string_view>

#include "protocol/transfer.h"

namespace platon {
namespace {

SessionToken newToken() {
  static std::uint32_t players = 0;
  ++players;
  SessionToken token{};
  for (std::size_t i = 0; i < 4; ++i) token[i] = static_cast<std::uint8_t>(players >> 8 * i);
  return token;
}

}  // namespace

template <class Message>
void FakeClient::send(const Message& message, bool reliable) {
  outgoing_.push_back({encode(message), reliable});
}

FakeClient::FakeClient(std::string name, std::uint32_t lead, Buttons buttons) : lead_(lead), token_(newToken()) {
  players_[0].buttons = std::move(buttons);
  send(Hello{kRulesVersion, std::move(name), token_}, true);
}

FakeClient::FakeClient(const FakeClient& disconnected, Buttons buttons)
    : lead_(disconnected.lead_), token_(disconnected.token_), texts_(disconnected.texts_) {
  for (std::size_t local = 1; local < players_.size(); ++local) {
    players_[local].buttons = disconnected.players_[local].buttons;
  }
  players_[0].buttons = std::move(buttons);
  Hello hello;
  hello.token = token_;
  for (const auto& [hash, level] : texts_) hello.levels.push_back(hash);
  send(hello, true);
}

void FakeClient::update(Time) {
  if (!game_) return;
  PlayerInputs message{round_, sync_,      confirmed_, shortHash(game_->hash()), std::max(confirmed_, firstInput_),
                       {},     sequence_++};
  message.inputs = inputsOf(players_[0], message.first);
  for (std::uint32_t local = 1; local < players_.size() && !message.inputs.empty(); ++local) {
    const Player& companion = players_[local];
    if (companion.slot) message.companions.push_back({local, message.first, inputsOf(companion, message.first)});
  }
  send(message, false);
}

std::vector<Input> FakeClient::inputsOf(const Player& player, std::uint32_t first) const {
  std::vector<Input> inputs;
  for (std::uint32_t tick = first; tick <= confirmed_ + lead_; ++tick) {
    inputs.push_back(validInput(static_cast<std::uint8_t>(player.buttons(tick) | Input::kPresent)));
  }
  return inputs;
}

void FakeClient::receive(std::vector<std::uint8_t> bytes, Time) {
  const auto message = decodeToClient(bytes);
  ASSERT_TRUE(message);
  std::visit([this](const auto& body) { handle(body); }, *message);
}

void FakeClient::handle(const Welcome& message) {
  welcome_ = message;
  players_[0].slot = message.slot;
  startRound(message.round, message.levelHash);
}

void FakeClient::handle(const RoundStart& message) {
  if (!startRound(message.round, message.levelHash)) send(LevelRequest{levelHash_}, true);
}

// False if the level is unknown.
bool FakeClient::startRound(std::uint32_t round, std::uint64_t levelHash) {
  round_ = round;
  levelHash_ = levelHash;
  game_.reset();
  const bool known = texts_.contains(levelHash);
  if (known) play();
  return known;
}

void FakeClient::handle(const LevelChunk& message) {
  if (!levelAssembly_.add(message.total, message.offset, message.bytes)) return;
  const std::vector<std::uint8_t>& text = levelAssembly_.bytes();
  const LevelResult level = loadLevel({reinterpret_cast<const char*>(text.data()), text.size()});
  ASSERT_TRUE(level.level);
  ASSERT_EQ(level.level->hash, message.hash);
  ++levels_;
  texts_[message.hash] = level.level;
  if (message.hash == levelHash_ && !game_) play();
}

void FakeClient::play() {
  game_.emplace(texts_[levelHash_]);
  confirmed_ = 0;
  firstInput_ = 0;
  sync_ = 0;
  held_.clear();
  hashes_.clear();
  for (Player& player : players_) player.decided.clear();
}

void FakeClient::handle(const StateChunk& message) {
  if (message.round != round_ || !stateAssembly_.add(message.total, message.offset, message.bytes)) return;
  const auto state = decodeFullState(stateAssembly_.bytes());
  ASSERT_TRUE(state);
  ASSERT_TRUE(game_->restore(state->game));
  held_ = state->held;
  confirmed_ = message.tick;
  sync_ = message.sync;
  ++states_;
}

void FakeClient::handle(const ConfirmedTicks& message) {
  if (message.link && message.link->slack) slack_ = message.link->slack;
  const std::uint32_t end = message.from + message.count;
  if (!game_ || message.round != round_ || confirmed_ < message.from || confirmed_ >= end) return;
  auto change = message.changes.begin();
  while (change != message.changes.end() && change->tick < confirmed_) ++change;
  for (; confirmed_ < end; ++confirmed_) {
    for (; change != message.changes.end() && change->tick == confirmed_; ++change) {
      if (held_.size() <= change->slot) held_.resize(change->slot + 1);
      held_[change->slot] = change->input;
    }
    for (Player& player : players_) {
      if (player.slot) player.decided[confirmed_] = *player.slot < held_.size() ? held_[*player.slot] : Input{};
    }
    game_->advance(held_);
    hashes_[confirmed_ + 1] = game_->hash();
  }
  if (shortHash(game_->hash()) != message.hash) ++desyncs_;
}

void FakeClient::vote(std::uint32_t round, bool next) { send(Vote{round, next}, true); }

void FakeClient::say(const Chat& chat, std::uint32_t local) { send(LocalChat{local, chat}, true); }

void FakeClient::addCompanion(std::uint32_t local, const std::string& name, Buttons buttons) {
  players_[local].buttons = std::move(buttons);
  send(Companion{local, true, name}, true);
}

void FakeClient::removeCompanion(std::uint32_t local) { send(Companion{local, false}, true); }

void FakeClient::handle(const LocalSlots& message) {
  localSlots_.push_back(message);
  for (std::size_t local = 0; local < players_.size(); ++local) players_[local].slot = message.slots[local];
}

void FakeClient::corruptGame() {
  ASSERT_TRUE(game_);
  game_->advance(std::vector<Input>(kMaxPlayers, Input{Input::kPresent}));
}

}  // namespace platon
