#include "client/replay/listed_run.h"

#include <array>
#include <chrono>
#include <cstdio>

namespace platon {

std::string dateText(std::filesystem::file_time_type date) {
  using namespace std::chrono;
  const year_month_day day(floor<days>(file_clock::to_sys(date)));
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%04d-%02u-%02u", static_cast<int>(day.year()),
                static_cast<unsigned>(day.month()), static_cast<unsigned>(day.day()));
  return text.data();
}

}  // namespace platon
