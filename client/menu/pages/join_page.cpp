#include "client/menu/pages/join_page.h"

namespace platon {
namespace {

MenuItem fieldItem(const char* name, TextField& field, bool secret) {
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

std::size_t itemOfList(const JoinForm& form) { return form.asksPassword ? 3 : 2; }

MenuPage joinPage(JoinForm& form, const std::function<void()>& join) {
  MenuPage page{"Join a server"};
  page.place = MenuPage::Place::kLeft;
  page.warning = !form.fault.empty();
  page.notes.push_back(form.fault.empty() ? "Enter the address of the server: HOST or HOST:PORT." : form.fault);
  if (!form.listFault.empty()) page.notes.push_back(form.listFault);
  page.items.push_back(fieldItem("Address", form.address, false));
  if (form.asksPassword) page.items.push_back(fieldItem("Password", form.password, true));
  page.items.push_back({.name = "Join", .choose = join});
  if (form.asksList) page.items.push_back(fieldItem("List of servers", form.listUrl, false));
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
