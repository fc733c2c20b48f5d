#pragma once

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <stop_token>
#include <string>

#include "protocol/transport/socket_address.h"

namespace platon {

/// Nothing came from a web server; `what()` is a clause with the cause.
class DownloadError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Whether a web server at one address may redirect to another. One of the internet leads to no private address, and
/// only one of this machine to this machine: it could otherwise ask a machine in the player's network for something, in
/// the player's name.
bool mayRedirect(const IpAddress& from, const IpAddress& to);

/// What a web server has at a URL, http or https, at most `maxBytes`, within 10 s. An https address leads only to
/// others of https, whose certificates the system trusts, and an address only to those for which `mayLead` is true. No
/// proxy is used. Throws DownloadError, also when a stop is requested.
std::string download(const std::string& url, std::size_t maxBytes, const std::stop_token& stop = {},
                     std::function<bool(const IpAddress& from, const IpAddress& to)> mayLead = mayRedirect);

/// Whether a URL names this machine: localhost, 127.0.0.0/8 or ::1.
bool isOfThisMachine(const std::string& url);

}  // namespace platon
