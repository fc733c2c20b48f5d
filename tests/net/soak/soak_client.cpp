#include "tests/net/soak/soak_client.h"

#include <random>

#include "client/bot/button_presser.h"
#include "client/bot/hollow_session.h"
#include "tests/net/support/pressing.h"

namespace platon {
namespace {

HollowSession::Buttons buttonsOf(std::uint64_t seed, bool isRestless) {
  if (!isRestless) return [presser = ButtonPresser(seed)]() mutable { return presser.next(); };
  return [random = std::mt19937_64(seed)]() mutable {
    const auto pressed = random() & (Input::kLeft | Input::kRight | Input::kJump);
    return validInput(static_cast<std::uint8_t>(pressed | Input::kPresent));
  };
}

std::optional<std::string> reasonOf(const std::optional<SessionEnding>& ending) {
  return ending ? std::optional(ending->reason) : std::nullopt;
}

class HollowClient : public SoakClient {
 public:
  HollowClient(const std::string& name, const SoakMemory& memory, std::uint64_t seed, bool isRestless, Time now)
      : session_(name, now, memory.token), buttons_(buttonsOf(seed, isRestless)) {}

  void receive(std::span<const std::uint8_t> bytes, Time now) override { session_.receive(bytes, now); }
  void update(Time now) override { session_.update(now, buttons_); }
  void leave() override { session_.leave(); }
  std::vector<OutgoingMessage> takeOutgoing() override { return session_.takeOutgoing(); }
  std::optional<std::string> ending() const override { return reasonOf(session_.ending()); }
  const std::optional<Welcome>& welcome() const override { return session_.welcome(); }
  std::uint64_t confirmedTicks() const override { return session_.confirmedTicks(); }
  void remember(SoakMemory&) const override {}

 private:
  HollowSession session_;
  HollowSession::Buttons buttons_;
};

class PlayingClient : public SoakClient {
 public:
  PlayingClient(const std::string& name, const SoakMemory& memory, std::uint64_t seed, Time now)
      : session_(name, now, withToken(memory)),
        controls_(pressing(seed)),
        before_(session_.predictionStatistics().confirmedTicks) {}

  void receive(std::span<const std::uint8_t> bytes, Time now) override { session_.receive(bytes, now); }
  void update(Time now) override { session_.update(now, controls_); }
  void leave() override { session_.leave(); }
  std::vector<OutgoingMessage> takeOutgoing() override { return session_.takeOutgoing(); }
  std::optional<std::string> ending() const override { return reasonOf(session_.ending()); }
  const std::optional<Welcome>& welcome() const override { return session_.welcome(); }
  std::uint64_t confirmedTicks() const override { return session_.predictionStatistics().confirmedTicks - before_; }
  void remember(SoakMemory& memory) const override { memory.game = session_.memory(); }
  const Session* session() const override { return &session_; }

 private:
  static Session::Memory withToken(const SoakMemory& memory) {
    Session::Memory game = memory.game;
    game.token = memory.token;
    return game;
  }

  Session session_;
  Controls controls_;
  std::uint32_t before_;
};

}  // namespace

std::unique_ptr<SoakClient> makeHollowClient(const std::string& name, const SoakMemory& memory, std::uint64_t seed,
                                             bool isRestless, Time now) {
  return std::make_unique<HollowClient>(name, memory, seed, isRestless, now);
}

std::unique_ptr<SoakClient> makePlayingClient(const std::string& name, const SoakMemory& memory, std::uint64_t seed,
                                              Time now) {
  return std::make_unique<PlayingClient>(name, memory, seed, now);
}

}  // namespace platon
