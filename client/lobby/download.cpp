#include "client/lobby/download.h"

#include <curl/curl.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "platon_version.h"
#include "protocol/transport/socket_address.h"

namespace platon {
namespace {

constexpr long kTimeout = 10;        // s
constexpr long kConnectTimeout = 5;  // s
constexpr long kMaxRedirections = 3;

struct Transfer {
  std::string content;
  std::size_t maxBytes = 0;
  std::stop_token stop;
  std::function<bool(const IpAddress&, const IpAddress&)> mayLead;
  CURL* curl = nullptr;
  std::vector<IpAddress> origins{};      // of the URL; curl tries several when one does not answer
  std::optional<IpAddress> forbidden{};  // where a redirection wanted to lead
  bool tooLong = false;
};

bool isOwn(const IpAddress& ip) {
  return ip.isThisMachine() || ip == IpAddress{} || (ip.isIpv4() && ip.ipv4()[0] == 0);
}

bool allows(Transfer& transfer, const IpAddress& ip) {
  long redirections = 0;
  curl_easy_getinfo(transfer.curl, CURLINFO_REDIRECT_COUNT, &redirections);
  if (redirections == 0) {
    transfer.origins.push_back(ip);
    return true;
  }
  const bool may = std::all_of(transfer.origins.begin(), transfer.origins.end(),
                               [&](const IpAddress& origin) { return transfer.mayLead(origin, ip); });
  if (!may) transfer.forbidden = ip;
  return may;
}

// Called by curl before it connects.
curl_socket_t openSocket(void* transfer, curlsocktype, curl_sockaddr* address) {
  SystemAddress system{};
  std::memcpy(&system, &address->addr, std::min<std::size_t>(address->addrlen, sizeof system));
  if (!allows(*static_cast<Transfer*>(transfer), fromSystem(system).ip)) return CURL_SOCKET_BAD;
  return socket(address->family, address->socktype | SOCK_CLOEXEC, address->protocol);
}

// Called by curl with `count` bytes; another result than `count` ends the transfer.
std::size_t take(const char* bytes, std::size_t size, std::size_t count, void* transfer) {
  auto& into = *static_cast<Transfer*>(transfer);
  into.tooLong = into.content.size() + size * count > into.maxBytes;
  if (into.tooLong) return 0;
  into.content.append(bytes, size * count);
  return size * count;
}

// Called by curl again and again; another result than 0 ends the transfer.
int progress(void* transfer, curl_off_t, curl_off_t, curl_off_t, curl_off_t) {
  return static_cast<Transfer*>(transfer)->stop.stop_requested() ? 1 : 0;
}

// Curl wants one call before all others in the program.
void startCurl() {
  static const bool started = curl_global_init(CURL_GLOBAL_DEFAULT) == CURLE_OK;
  if (!started) throw DownloadError("libcurl does not start");
}

void describe(CURL* curl, const std::string& url, Transfer& transfer, char* reason) {
  const bool secure = url.starts_with("https://");
  curl_easy_setopt(curl, CURLOPT_URL, url.c_str());
  curl_easy_setopt(curl, CURLOPT_PROTOCOLS_STR, "http,https");
  curl_easy_setopt(curl, CURLOPT_REDIR_PROTOCOLS_STR, secure ? "https" : "http,https");
  curl_easy_setopt(curl, CURLOPT_PROXY, "");  // one of the environment would hide where a redirection leads
  curl_easy_setopt(curl, CURLOPT_FOLLOWLOCATION, 1L);
  curl_easy_setopt(curl, CURLOPT_MAXREDIRS, kMaxRedirections);
  curl_easy_setopt(curl, CURLOPT_FAILONERROR, 1L);
  curl_easy_setopt(curl, CURLOPT_NOSIGNAL, 1L);
  // A server may close a connection on which curl asks again. Curl then asks on another one, but the reason of a later
  // failure would be that of the closed connection.
  curl_easy_setopt(curl, CURLOPT_FORBID_REUSE, 1L);
  curl_easy_setopt(curl, CURLOPT_QUICK_EXIT, 1L);  // does not wait for a name that is looked up
  curl_easy_setopt(curl, CURLOPT_TIMEOUT, kTimeout);
  curl_easy_setopt(curl, CURLOPT_CONNECTTIMEOUT, kConnectTimeout);
  curl_easy_setopt(curl, CURLOPT_USERAGENT, ("platon-client/" + std::string(kVersion)).c_str());
  curl_easy_setopt(curl, CURLOPT_ERRORBUFFER, reason);
  curl_easy_setopt(curl, CURLOPT_OPENSOCKETFUNCTION, openSocket);
  curl_easy_setopt(curl, CURLOPT_OPENSOCKETDATA, &transfer);
  curl_easy_setopt(curl, CURLOPT_WRITEFUNCTION, take);
  curl_easy_setopt(curl, CURLOPT_WRITEDATA, &transfer);
  curl_easy_setopt(curl, CURLOPT_NOPROGRESS, 0L);
  curl_easy_setopt(curl, CURLOPT_XFERINFOFUNCTION, progress);
  curl_easy_setopt(curl, CURLOPT_XFERINFODATA, &transfer);
}

}  // namespace

bool mayRedirect(const IpAddress& from, const IpAddress& to) {
  if (isOwn(to)) return isOwn(from);
  return from.isPrivate() || !to.isPrivate();
}

std::string download(const std::string& url, std::size_t maxBytes, const std::stop_token& stop,
                     std::function<bool(const IpAddress& from, const IpAddress& to)> mayLead) {
  startCurl();
  const std::unique_ptr<CURL, decltype(&curl_easy_cleanup)> curl(curl_easy_init(), curl_easy_cleanup);
  if (!curl) throw DownloadError("libcurl does not start");
  Transfer transfer{{}, maxBytes, stop, std::move(mayLead), curl.get()};
  std::array<char, CURL_ERROR_SIZE> reason{};
  describe(curl.get(), url, transfer, reason.data());
  const CURLcode result = curl_easy_perform(curl.get());
  if (transfer.tooLong) throw DownloadError("it has more than " + std::to_string(maxBytes) + " bytes");
  if (stop.stop_requested()) throw DownloadError("stopped");
  if (transfer.forbidden) {
    throw DownloadError("it redirects to " + transfer.forbidden->text() +
                        ", an address of this machine or of a private network; only a list from there may");
  }
  if (result != CURLE_OK) throw DownloadError(reason[0] != '\0' ? reason.data() : curl_easy_strerror(result));
  return std::move(transfer.content);
}

bool isOfThisMachine(const std::string& url) {
  const std::unique_ptr<CURLU, decltype(&curl_url_cleanup)> parsed(curl_url(), curl_url_cleanup);
  if (!parsed || curl_url_set(parsed.get(), CURLUPART_URL, url.c_str(), 0) != CURLUE_OK) return false;
  char* part = nullptr;
  if (curl_url_get(parsed.get(), CURLUPART_HOST, &part, 0) != CURLUE_OK) return false;
  const std::unique_ptr<char, decltype(&curl_free)> owned(part, curl_free);
  std::string_view host = part;
  if (host == "localhost") return true;
  if (host.starts_with('[') && host.ends_with(']')) host = host.substr(1, host.size() - 2);
  const auto ip = IpAddress::parse(host);
  return ip && ip->isThisMachine();
}

}  // namespace platon
