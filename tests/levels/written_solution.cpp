#include "tests/levels/written_solution.h"

#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

namespace platon {
namespace {

const std::map<std::string, std::uint8_t> kButtons = {
    {"wait", 0}, {"left", Input::kLeft}, {"right", Input::kRight}, {"jump", Input::kJump}, {"down", Input::kDown}};

void readLine(const std::string& line, std::vector<Input>& inputs) {
  std::istringstream words(line.substr(0, line.find('#')));
  std::string word;
  if (!(words >> word)) return;
  const std::size_t ticks = std::stoul(word);
  Input input{Input::kPresent};
  std::size_t buttons = 0;
  for (; words >> word; ++buttons) input.buttons |= kButtons.at(word);
  if (ticks == 0 || buttons == 0) throw std::invalid_argument("missing ticks or button");
  inputs.insert(inputs.end(), ticks, input);
}

}  // namespace

std::vector<Input> readSolution(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot read " + path);
  std::vector<Input> inputs;
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    try {
      readLine(line, inputs);
    } catch (const std::logic_error& error) {
      throw std::runtime_error(path + ":" + std::to_string(number) + ": " + error.what());
    }
  }
  return inputs;
}

}  // namespace platon
