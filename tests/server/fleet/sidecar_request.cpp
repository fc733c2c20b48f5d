#include "tests/server/fleet/sidecar_request.h"

#include <algorithm>
#include <array>
#include <regex>
#include <set>
#include <stdexcept>
#include <string_view>

namespace platon {
namespace {

// An operation: every one but GET consumes application/json and has a body that must be there. All answer with 200.
struct Operation {
  std::string_view method;
  std::string_view path;              // {} stands for a name
  std::set<std::string> int64Values;  // the properties of the body, none of which must be there
};

// Facts from sdks/swagger/sdk.swagger.json and, for v1beta1, beta.swagger.json of github.com/googleforgames/agones at
// b19d5fe, which is 1.57.0 in development. Only the operations that the server uses.
const std::array<Operation, 6> kOperations{
    Operation{"POST", "/allocate", {}}, Operation{"GET", "/gameserver", {}},
    Operation{"POST", "/health", {}},   Operation{"POST", "/ready", {}},
    Operation{"POST", "/shutdown", {}}, Operation{"PATCH", "/v1beta1/counters/{}", {"capacity", "count", "countDiff"}}};

[[noreturn]] void refuse(const std::string& what) { throw std::invalid_argument(what); }

bool fits(const std::string& path, std::string_view pattern) {
  const std::size_t name = pattern.find("{}");
  if (name == std::string_view::npos) return path == pattern;
  return path.starts_with(pattern.substr(0, name)) && path.size() > name && path.find('/', name) == std::string::npos;
}

const Operation& operationOf(const SidecarRequest& request) {
  const auto* const found = std::find_if(kOperations.begin(), kOperations.end(), [&](const Operation& operation) {
    return request.method == operation.method && fits(request.path, operation.path);
  });
  if (found == kOperations.end()) refuse("there is no " + request.method + " " + request.path);
  return *found;
}

// The properties of an object without objects in it, whose values are strings.
std::map<std::string, std::string> propertiesOf(const std::string& text) {
  static const std::regex object(R"re(\s*\{\s*("\w+"\s*:\s*"[^"\\]*"\s*(,\s*"\w+"\s*:\s*"[^"\\]*"\s*)*)?\}\s*)re");
  static const std::regex property(R"re("(\w+)"\s*:\s*"([^"\\]*)")re");
  if (!std::regex_match(text, object)) refuse("the body is no object of strings: " + text);
  std::map<std::string, std::string> properties;
  for (auto at = std::sregex_iterator(text.begin(), text.end(), property); at != std::sregex_iterator(); ++at) {
    if (!properties.emplace((*at)[1], (*at)[2]).second) refuse("the property " + (*at)[1].str() + " is there twice");
  }
  return properties;
}

void check(const std::map<std::string, std::string>& body, const Operation& operation) {
  static const std::regex int64("-?[0-9]{1,19}");
  for (const auto& [name, value] : body) {
    if (!operation.int64Values.contains(name))
      refuse(std::string(operation.path).append(" has no property ").append(name));
    if (!std::regex_match(value, int64)) refuse(name + " is no number of 64 bits: " + value);
  }
}

}  // namespace

SidecarRequest SidecarRequest::read(const std::string& request) {
  static const std::regex firstLine("([A-Z]+) (\\S+) HTTP/1\\.[01]");
  const std::string line = request.substr(0, request.find("\r\n"));
  const std::size_t head = request.find("\r\n\r\n");
  std::smatch words;
  if (head == std::string::npos || !std::regex_match(line, words, firstLine)) refuse("this is no request: " + line);
  SidecarRequest read{words[1], words[2], request.substr(head + 4), {}};
  const Operation& operation = operationOf(read);
  if (read.method == "GET") {
    if (!read.text.empty()) refuse("GET has no body");
    return read;
  }
  if (request.substr(0, head + 2).find("\r\nContent-Type: application/json\r\n") == std::string::npos)
    refuse("the body is not declared as application/json");
  read.body = propertiesOf(read.text);
  check(read.body, operation);
  return read;
}

}  // namespace platon
