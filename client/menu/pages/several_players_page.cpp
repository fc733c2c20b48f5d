#include "client/menu/pages/several_players_page.h"

#include <algorithm>
#include <cmath>

#include "protocol/limits.h"

namespace platon {
namespace {

constexpr double kMaxHosted = 64;

MenuItem levelItem(HostForm& form, std::span<const LevelEntry> levels) {
  MenuItem item{MenuItem::Kind::kChoice, "First level", levels.empty() ? "" : levels[form.level].title};
  item.step = [&form, levels](int direction) {
    if (levels.empty()) return;
    const std::size_t count = levels.size();
    form.level = (form.level + count + static_cast<std::size_t>(direction)) % count;
  };
  return item;
}

MenuItem rotationItem(HostForm& form) {
  MenuItem item{MenuItem::Kind::kChoice, "Then", form.onlyLevel ? "the same level" : "the next levels"};
  item.flips = true;
  item.step = [&form](int) { form.onlyLevel = !form.onlyLevel; };
  return item;
}

MenuItem playersItem(HostForm& form) {
  MenuItem item{MenuItem::Kind::kSlider, "Player limit", std::to_string(std::lround(form.players)),
                (form.players - 1) / (kMaxHosted - 1)};
  item.step = [&form](int direction) { form.players = std::clamp(form.players + direction, 1.0, kMaxHosted); };
  item.set = [&form](double part) { form.players = std::round(1 + part * (kMaxHosted - 1)); };
  return item;
}

MenuItem fieldItem(const char* name, TextField& field, bool secret = false) {
  MenuItem item{MenuItem::Kind::kText, name};
  item.field = &field;
  item.secret = secret;
  return item;
}

MenuItem serverItem(const std::string& name, const std::string& about, const std::string& address, JoinForm& form,
                    const std::function<void()>& join) {
  MenuItem item{.name = name, .value = about};
  item.choose = [&form, address, join] {
    form.address.setText(address);
    join();
  };
  return item;
}

}  // namespace

MenuPage severalPlayersPage(const LevelEntry& level, const SeveralPlayersChoices& choices) {
  MenuPage page{level.title};
  page.place = MenuPage::Place::kLeft;
  page.notes = {"This level needs " + std::to_string(level.players) +
                " players: play it together on this machine, host it so that others can join you, or join somebody who "
                "hosts it."};
  page.items = {{.name = "Together on this machine", .choose = choices.playHere},
                {.name = "Host it", .choose = choices.host},
                {.name = "Join", .choose = choices.join}};
  return page;
}

HostForm::HostForm() { port.setText(std::to_string(kDefaultPort)); }

MenuPage hostPage(HostForm& form, std::span<const LevelEntry> levels, const std::function<void()>& host) {
  MenuPage page{"Host a game"};
  page.place = MenuPage::Place::kLeft;
  page.warning = !form.fault.empty();
  page.notes.push_back(form.fault.empty() ? "Others join at your address, on the UDP port below." : form.fault);
  page.items = {levelItem(form, levels),
                rotationItem(form),
                playersItem(form),
                fieldItem("Port", form.port),
                fieldItem("Password, if any", form.password),
                {.name = "Start", .choose = host}};
  return page;
}

std::size_t itemOfList(const JoinForm& form) { return form.asksPassword ? 3 : 2; }

MenuPage joinPage(JoinForm& form, const std::function<void()>& join) {
  MenuPage page{"Join a server"};
  page.place = MenuPage::Place::kLeft;
  page.warning = !form.fault.empty();
  page.notes.push_back(form.fault.empty() ? "Enter the address of the server: HOST or HOST:PORT." : form.fault);
  if (!form.listFault.empty()) page.notes.push_back(form.listFault);
  page.items.push_back(fieldItem("Address", form.address));
  if (form.asksPassword) page.items.push_back(fieldItem("Password", form.password, true));
  page.items.push_back({.name = "Join", .choose = join});
  if (form.asksList) page.items.push_back(fieldItem("List of servers", form.listUrl));
  if (!form.recent.empty()) page.items.push_back({MenuItem::Kind::kHeading, "Joined before"});
  for (const std::string& address : form.recent) page.items.push_back(serverItem(address, "", address, form, join));
  // Last, so that a server that appears moves no item from under the focus.
  if (!form.found.empty())
    page.items.push_back({MenuItem::Kind::kHeading, form.hasList ? "Nearby and in the list" : "Nearby"});
  for (const JoinForm::Found& server : form.found)
    page.items.push_back(serverItem(server.name, server.about, server.address, form, join));
  return page;
}

}  // namespace platon
