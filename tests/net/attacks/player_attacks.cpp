#include "tests/net/attacks/player_attacks.h"

#include <span>
#include <vector>

#include "protocol/transport/enet_layer.h"
#include "tests/net/attacks/hostile_player.h"
#include "tests/net/attacks/hostile_session.h"
#include "tests/net/support/raw_content.h"

namespace platon {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr std::size_t kPlayers = 4 * kOwnHouseholds;  // as many as may play from these
constexpr std::size_t kCrowd = 64;
constexpr std::size_t kVoters = 3;  // fewer than the players attacked, who are no fewer than half then
constexpr std::size_t kDeaf = 3 * kOwnHouseholds;
constexpr Time kShortLife = milliseconds(100);

/// Hostile players in four households.
class PlayerAttack : public Attacker {
 public:
  PlayerAttack(AttackNetwork& network, Manners manners, std::size_t players) : manners_(std::move(manners)) {
    for (std::size_t i = 0; i < players; ++i) {
      const IpAddress own = ownAddress(network.version(), static_cast<int>(i));
      players_.push_back(std::make_unique<HostilePlayer>(network, own, manners_, i));
    }
  }

  void step(Time now, int) override {
    for (const auto& player : players_) player->step(now);
  }

 private:
  Manners manners_;
  std::vector<std::unique_ptr<HostilePlayer>> players_;
};

/// A player whose acknowledgements, four times a second, are all false, so that the server goes on repeating. He joins
/// again when the server has noticed.
class FalseAcknowledger {
 public:
  enum class Kind {
    kNeverSent,   ///< acknowledges what the server has never sent
    kHalfRoamed,  ///< the same, but sends in the names of others, and does not answer the challenges there
    kInFuture,    ///< acknowledges what was sent, with a time that has not come
  };

  FalseAcknowledger(AttackNetwork& network, const IpAddress& own, Kind kind)
      : network_(network), own_(own), kind_(kind) {}

  void step(Time now) {
    now_ = now;
    if (!session_ || now - since_ >= kLife) begin(now);
    session_->step(now);
    if (!session_->peer() || now - spokeAt_ < kInterval) return;
    spokeAt_ = now;
    if (!saidHello_) return sayHello(now);
    if (welcome_) speak(now);
  }

 private:
  static constexpr Time kLife = milliseconds(10500);  // a little more than it lasts if it acknowledges nothing
  static constexpr Time kInterval = milliseconds(250);
  static constexpr std::uint16_t kNeverSent = 40000;
  static constexpr std::uint16_t kFirstMessages = 8;

  void begin(Time now) {
    saidHello_ = false;
    welcome_.reset();
    requested_ = false;
    since_ = now;
    session_.emplace(network_, own_, [this](const Bytes& content) { receive(content); });
  }

  void sayHello(Time now) {
    saidHello_ = true;
    session_->send(reliableContent(*session_->peer(), 1, encode(Hello{})), now);
  }

  void speak(Time now) {
    PlayerInputs inputs{.round = welcome_->round};
    inputs.hash = 0x5a5a5a5a;
    inputs.inputs.assign(1, Input{Input::kPresent | Input::kJump});
    std::vector<Bytes> contents = acknowledgements();
    contents.push_back(unsequencedContent(*session_->peer(), encode(inputs)));
    if (!requested_)
      contents.push_back(reliableContent(*session_->peer(), 2, encode(LevelRequest{welcome_->levelHash})));
    const Bytes content = joinedContents(contents);
    if (kind_ != Kind::kHalfRoamed || !requested_) {
      session_->send(content, now);
    } else {
      session_->leaveAddress();
      session_->sendFrom(anyStranger(network_, dice_), content, now);
    }
    requested_ = true;
  }

  // ENet takes a time for one of the past if its highest bit differs.
  std::vector<Bytes> acknowledgements() const {
    if (kind_ != Kind::kInFuture)
      return {acknowledgeContent(*session_->peer(), kNeverSent, kReliableChannel, serverTime())};
    std::vector<Bytes> all;
    const auto time = static_cast<std::uint16_t>(serverTime() | 0x7fff);
    for (std::uint16_t sequence = 1; sequence <= kFirstMessages; ++sequence) {
      all.push_back(acknowledgeContent(*session_->peer(), sequence, kReliableChannel, time));
    }
    return all;
  }

  std::uint16_t serverTime() const {
    return static_cast<std::uint16_t>(heardTime_ + (now_ - heardAt_) / milliseconds(1));
  }

  void receive(const Bytes& content) {
    const std::optional<EnetCommands> commands = readEnetCommands(content, EnetSender::kServer);
    if (!commands) return;
    if (commands->commands[0].offset == kCommandAt) {
      heardTime_ = sentTimeOf(content);
      heardAt_ = now_;
    }
    std::size_t others = 0;
    for (const EnetCommand& command : std::span(commands->commands).first(commands->count)) {
      const bool isTick = command.command == ENET_PROTOCOL_COMMAND_SEND_UNSEQUENCED;
      others += isTick ? 0 : command.bytes;
      if (command.command == ENET_PROTOCOL_COMMAND_SEND_RELIABLE)
        note(ByteSpan(content).subspan(command.offset, command.bytes));
    }
    const bool hasTicks = commands->commands[0].offset + others < content.size();
    if (hasTicks) network_.noteTicks(content.size() + SealedChannel::kOverhead - others);
  }

  void note(ByteSpan command) {
    const std::optional<ToClient> message = decodeToClient(command.subspan(sizeof(ENetProtocolSendReliable)));
    const Welcome* const welcome = message ? std::get_if<Welcome>(&*message) : nullptr;
    if (welcome != nullptr) welcome_ = *welcome;
  }

  AttackNetwork& network_;
  IpAddress own_;
  Kind kind_;
  std::optional<HostileSession> session_;
  bool saidHello_ = false;
  std::optional<Welcome> welcome_;
  bool requested_ = false;       // the level
  std::uint16_t heardTime_ = 0;  // of the server, in the last content that has one
  Time heardAt_{};
  Time now_{};
  Time since_{};
  Time spokeAt_{};
  Dice dice_;
};

/// One of them in each household.
class FalseAcknowledgers : public Attacker {
 public:
  FalseAcknowledgers(AttackNetwork& network, FalseAcknowledger::Kind kind) {
    for (int i = 0; i < kOwnHouseholds; ++i) {
      players_.push_back(std::make_unique<FalseAcknowledger>(network, ownAddress(network.version(), i), kind));
    }
  }

  void step(Time now, int) override {
    for (const auto& player : players_) player->step(now);
  }

 private:
  std::vector<std::unique_ptr<FalseAcknowledger>> players_;
};

/// A player who goes to another household twice a second, at random so that some become empty, and resumes in another
/// one after a while. Refused, it tries another one.
class Wanderer {
 public:
  Wanderer(AttackNetwork& network, std::uint8_t number) : network_(network) {
    hello_.token = SessionToken{number, 1};
    for (int i = 0; i < number; ++i) dice_.below(1);
  }

  void step(Time now) {
    if (!session_ || now - since_ >= (plays_ ? kLife : kPatience)) begin(now);
    session_->step(now);
    if (!session_->peer() || now - movedAt_ < kInterval) return;
    movedAt_ = now;
    if (!saidHello_) {
      saidHello_ = true;
      return session_->send(reliableContent(*session_->peer(), 1, encode(hello_)), now);
    }
    session_->move(anyHousehold());
    session_->send(pingContent(*session_->peer()), now);
  }

 private:
  static constexpr Time kLife = seconds(2);
  static constexpr Time kPatience = seconds(1);
  static constexpr Time kInterval = milliseconds(500);

  IpAddress anyHousehold() { return ownAddress(network_.version(), dice_.below(kOwnHouseholds)); }

  // Its old session ends at once, or there would be no room for the new one; its player stays.
  void begin(Time now) {
    if (session_ && session_->peer()) session_->send(disconnectContent(*session_->peer()), now);
    saidHello_ = plays_ = false;
    since_ = now;
    session_.emplace(network_, anyHousehold(), [this](const Bytes& content) { receive(content); });
  }

  // Only players are sent ticks.
  void receive(const Bytes& content) {
    const std::optional<EnetCommands> commands = readEnetCommands(content, EnetSender::kServer);
    plays_ = plays_ || (commands && commands->commands[0].command == ENET_PROTOCOL_COMMAND_SEND_UNSEQUENCED);
  }

  AttackNetwork& network_;
  Hello hello_;
  std::optional<HostileSession> session_;
  bool saidHello_ = false;
  bool plays_ = false;
  Time since_{};
  Time movedAt_{};
  Dice dice_;
};

/// More than may play, and fewer than can have sessions, so that the households have room for those who move.
class Wanderers : public Attacker {
 public:
  explicit Wanderers(AttackNetwork& network) {
    for (std::size_t i = 0; i < kPlayers * 3 / 2; ++i) {
      wanderers_.push_back(std::make_unique<Wanderer>(network, static_cast<std::uint8_t>(i)));
    }
  }

  void step(Time now, int) override {
    for (const auto& wanderer : wanderers_) wanderer->step(now);
  }

 private:
  std::vector<std::unique_ptr<Wanderer>> wanderers_;
};

std::unique_ptr<Attacker> attackOf(AttackNetwork& network, Manners manners, std::size_t players) {
  return std::make_unique<PlayerAttack>(network, std::move(manners), players);
}

void makeHashWrong(ToServer& message, AttackNetwork&, Dice&) {
  if (auto* const inputs = std::get_if<PlayerInputs>(&message)) inputs->hash ^= 0x5a5a5a5a;
}

void moveInputs(ToServer& message, AttackNetwork&, Dice& dice) {
  auto* const inputs = std::get_if<PlayerInputs>(&message);
  if (inputs == nullptr) return;
  constexpr std::uint32_t kFar[] = {1, 127, 128, 129, 100000, 1u << 30};
  inputs->first += kFar[dice.below(std::size(kFar))];
  if (dice.below(4) == 0) inputs->round += static_cast<std::uint32_t>(dice.below(5));
  if (dice.below(4) == 0) inputs->inputs.assign(kMaxInputsPerMessage, Input{Input::kPresent | Input::kJump});
}

void sendManyInputs(EnetLink& connection, const Welcome& welcome, Dice& dice) {
  PlayerInputs inputs;
  inputs.round = welcome.round;
  inputs.confirmed = static_cast<std::uint32_t>(dice.below(1 << 20));
  inputs.first = inputs.confirmed + static_cast<std::uint32_t>(dice.below(1 << 20));
  inputs.inputs.assign(kMaxInputsPerMessage, Input{Input::kPresent | Input::kJump});
  connection.send(encode(inputs), false);
}

void requestLevel(EnetLink& connection, const Welcome& welcome, Dice& dice) {
  connection.send(encode(LevelRequest{welcome.levelHash + (dice.below(2) == 0 ? 0 : 1)}), true);
}

// As many as fit the budget of a connection, most of them for the present round.
void voteOften(EnetLink& connection, const Welcome& welcome, Dice& dice) {
  for (int i = 0; i < 4; ++i) {
    const auto other = static_cast<std::uint32_t>(dice.below(8) == 0 ? dice.below(1 << 20) : 0);
    connection.send(encode(Vote{welcome.round + other, dice.below(2) == 0}), true);
  }
}

// As much as fits the budget of a connection: emotes, and the longest texts.
void talk(EnetLink& connection, const Welcome&, Dice& dice) {
  for (int i = 0; i < 4; ++i) {
    const bool emote = dice.below(4) == 0;
    connection.send(encode(LocalChat{0, emote ? Chat{"", 1} : Chat{std::string(kMaxChatBytes, 'x'), 0}}), true);
  }
}

// As many as fit the budget of a connection; some for players that there cannot be.
void changeCompanion(EnetLink& connection, const Welcome&, Dice& dice) {
  for (int i = 0; i < 4; ++i) {
    Companion companion{1 + static_cast<std::uint32_t>(dice.below(dice.below(8) == 0 ? 255 : 3)), dice.below(3) != 0};
    if (companion.joins) companion.name = std::string(kMaxNameBytes - 8, 'x') + std::to_string(dice.below(1 << 20));
    connection.send(encode(companion), true);
  }
}

// The same inputs for every companion, whether it plays or not.
void pressForCompanions(ToServer& message, AttackNetwork&, Dice& dice) {
  auto* const inputs = std::get_if<PlayerInputs>(&message);
  if (inputs == nullptr || inputs->inputs.empty()) return;
  for (std::uint32_t local = 1; local < kMaxLocalPlayers; ++local) {
    inputs->companions.push_back({local, inputs->first + static_cast<std::uint32_t>(dice.below(200)), inputs->inputs});
  }
}

// A part of a recorded datagram, or any bytes.
void setToken(ToServer& message, AttackNetwork& network, Dice& dice) {
  auto* const hello = std::get_if<Hello>(&message);
  if (hello == nullptr) return;
  hello->token.emplace();
  dice.fill(*hello->token);
  const Overheard* const found = anyToServer(network, dice);
  if (found == nullptr || found->bytes.size() < hello->token->size() || dice.below(2) == 0) return;
  const auto at = dice.below(found->bytes.size() - hello->token->size() + 1);
  std::copy_n(found->bytes.begin() + at, hello->token->size(), hello->token->begin());
}

}  // namespace

std::unique_ptr<Attacker> acknowledgeNothing(AttackNetwork& network) {
  Manners manners{.tamper = makeHashWrong, .extra = requestLevel};
  manners.life = seconds(8);
  manners.deafAfter = milliseconds(300);
  return attackOf(network, manners, kDeaf);
}

std::unique_ptr<Attacker> acknowledgeFalsely(AttackNetwork& network) {
  return std::make_unique<FalseAcknowledgers>(network, FalseAcknowledger::Kind::kNeverSent);
}

std::unique_ptr<Attacker> roamHalf(AttackNetwork& network) {
  return std::make_unique<FalseAcknowledgers>(network, FalseAcknowledger::Kind::kHalfRoamed);
}

std::unique_ptr<Attacker> acknowledgeInFuture(AttackNetwork& network) {
  return std::make_unique<FalseAcknowledgers>(network, FalseAcknowledger::Kind::kInFuture);
}

std::unique_ptr<Attacker> roamForPlaces(AttackNetwork& network) { return std::make_unique<Wanderers>(network); }

std::unique_ptr<Attacker> sendFarInputs(AttackNetwork& network) {
  return attackOf(network, {.tamper = moveInputs, .extra = sendManyInputs}, kPlayers);
}

std::unique_ptr<Attacker> sendWrongHashes(AttackNetwork& network) {
  return attackOf(network, {.tamper = makeHashWrong, .extra = {}}, kPlayers);
}

std::unique_ptr<Attacker> requestLevels(AttackNetwork& network) {
  return attackOf(network, {.tamper = {}, .extra = requestLevel}, kPlayers);
}

std::unique_ptr<Attacker> castVotes(AttackNetwork& network) {
  return attackOf(network, {.tamper = {}, .extra = voteOften}, kVoters);
}

std::unique_ptr<Attacker> talkWithoutEnd(AttackNetwork& network) {
  return attackOf(network, {.tamper = {}, .extra = talk}, kPlayers);
}

// One connection in each household, so that the companions have room.
std::unique_ptr<Attacker> changeCompanions(AttackNetwork& network) {
  return attackOf(network, {.tamper = pressForCompanions, .extra = changeCompanion}, kOwnHouseholds);
}

std::unique_ptr<Attacker> sendMalformed(AttackNetwork& network) {
  Manners manners;
  manners.extra = [](EnetLink& connection, const Welcome&, Dice& dice) {
    connection.send(dice.bytes(1 + static_cast<std::size_t>(dice.below(1000))), dice.below(2) == 0);
  };
  return attackOf(network, manners, kPlayers);
}

std::unique_ptr<Attacker> guessTokens(AttackNetwork& network) {
  Manners manners{.tamper = setToken, .extra = {}};
  manners.life = seconds(1);
  manners.leaves = true;
  return attackOf(network, manners, kPlayers);
}

std::unique_ptr<Attacker> joinAndLeave(AttackNetwork& network) {
  Manners manners;
  manners.life = 2 * kShortLife;
  manners.leaves = true;
  return attackOf(network, manners, kCrowd);
}

std::unique_ptr<Attacker> joinAndVanish(AttackNetwork& network) {
  Manners manners{.tamper = setToken, .extra = {}};
  manners.life = 2 * kShortLife;
  return attackOf(network, manners, kCrowd);
}

}  // namespace platon
