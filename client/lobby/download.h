#pragma once

#include <cstddef>
#include <stdexcept>
#include <stop_token>
#include <string>

namespace platon {

/// Nothing came from a web server; `what()` is a clause with the cause.
class DownloadError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What a web server has at a URL, http or https, at most `maxBytes`, within 10 s. An https address leads only to
/// others of https, whose certificates the system trusts. Throws DownloadError, also when a stop is requested.
std::string download(const std::string& url, std::size_t maxBytes, const std::stop_token& stop = {});

/// Whether a URL names this machine: localhost, 127.0.0.0/8 or ::1.
bool isOfThisMachine(const std::string& url);

}  // namespace platon
