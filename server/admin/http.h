#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace platon {

/// Longest head of a request, bytes.
inline constexpr std::size_t kMaxHttpHeadBytes = 8 * 1024;

enum class HttpStatus {
  kOk = 200,
  kBadRequest = 400,
  kNotFound = 404,
  kMethodNotAllowed = 405,
  kHeadTooLarge = 431,
};

/// The status with which a server that has the one page `path`, for GET alone, answers a request of HTTP/1.0 or
/// HTTP/1.1. `received`: all that has arrived so far. Nothing as long as the head of the request is incomplete.
std::optional<HttpStatus> answerTo(std::string_view received, std::string_view path);

/// A complete response, after which the connection closes. `body`: of kOk; the others have one that names the status.
std::string httpResponse(HttpStatus status, std::string_view contentType, std::string_view body);

}  // namespace platon
