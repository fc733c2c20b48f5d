#include "server/admin/http.h"

#include <algorithm>

namespace platon {
namespace {

std::string_view nameOf(HttpStatus status) {
  switch (status) {
    case HttpStatus::kOk:
      return "OK";
    case HttpStatus::kBadRequest:
      return "Bad Request";
    case HttpStatus::kNotFound:
      return "Not Found";
    case HttpStatus::kMethodNotAllowed:
      return "Method Not Allowed";
    case HttpStatus::kHeadTooLarge:
      return "Request Header Fields Too Large";
  }
  return "";
}

bool isMethod(std::string_view word) {
  return !word.empty() && std::all_of(word.begin(), word.end(), [](char byte) { return byte >= 'A' && byte <= 'Z'; });
}

bool isTarget(std::string_view word) {
  return word.starts_with('/') &&
         std::all_of(word.begin(), word.end(), [](char byte) { return byte > ' ' && byte < 127; });
}

}  // namespace

std::optional<HttpStatus> answerTo(std::string_view received, std::string_view path) {
  const std::size_t end = received.find("\r\n\r\n");
  if (std::min(end, received.size()) > kMaxHttpHeadBytes) return HttpStatus::kHeadTooLarge;
  if (end == std::string_view::npos) return std::nullopt;
  const std::string_view line = received.substr(0, received.find("\r\n"));
  const std::size_t first = line.find(' ');
  const std::size_t last = line.rfind(' ');
  if (first == std::string_view::npos || first == last) return HttpStatus::kBadRequest;
  const std::string_view method = line.substr(0, first);
  const std::string_view target = line.substr(first + 1, last - first - 1);
  const std::string_view version = line.substr(last + 1);
  const bool known = version == "HTTP/1.1" || version == "HTTP/1.0";
  if (!isMethod(method) || !isTarget(target) || !known) return HttpStatus::kBadRequest;
  if (target.substr(0, target.find('?')) != path) return HttpStatus::kNotFound;
  return method == "GET" ? HttpStatus::kOk : HttpStatus::kMethodNotAllowed;
}

std::string httpResponse(HttpStatus status, std::string_view contentType, std::string_view body) {
  const bool ok = status == HttpStatus::kOk;
  const std::string content = ok ? std::string(body) : std::string(nameOf(status)) + "\n";
  std::string response = "HTTP/1.1 " + std::to_string(static_cast<int>(status)) + " " + std::string(nameOf(status));
  if (status == HttpStatus::kMethodNotAllowed) response += "\r\nAllow: GET";
  response.append("\r\nContent-Type: ").append(ok ? contentType : "text/plain");
  response += "\r\nContent-Length: " + std::to_string(content.size()) + "\r\nConnection: close\r\n\r\n";
  return response + content;
}

}  // namespace platon
