#include "flash.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>

namespace cycles {

bool LineCache::use(uint64_t line) {
  std::deque<uint64_t>& set = sets_[line % sets_.size()];
  const auto found = std::find(set.begin(), set.end(), line);
  const bool was_in = found != set.end();
  if (was_in) {
    set.erase(found);
  } else if (set.size() == ways_) {
    set.pop_back();
  }
  set.push_front(line);
  return was_in;
}

bool LineCache::has(uint64_t line) const {
  const std::deque<uint64_t>& set = sets_[line % sets_.size()];
  return std::find(set.begin(), set.end(), line) != set.end();
}

std::string Flash::read(const std::string& path, const std::string& name, FlashProfile& profile) {
  std::ifstream file(path);
  std::string known;
  std::string line;
  std::getline(file, line);  // the head
  while (std::getline(file, line)) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream cells(line);
    std::string row;
    FlashProfile read;
    if (!(cells >> row >> read.line_bytes >> read.sets >> read.ways >> read.data_lines >>
          read.wait >> read.prefetches)) {
      return std::string(path).append(": '").append(row).append(
          "' is no row of a name and six numbers");
    }
    known.append(" ").append(row);
    if (row == name) {
      profile = read;
      return "";
    }
  }
  return "flash=" + name + ": no profile of " + path + ", which has" + known;
}

Flash::Flash(const FlashProfile& profile, uint64_t begin, uint64_t bytes)
    : profile_(profile),
      begin_(begin),
      bytes_(bytes),
      instructions_(profile.sets, profile.ways),
      data_(1, profile.data_lines) {}

uint64_t Flash::fetch_line(uint64_t line, uint64_t now) {
  uint64_t waited = 0;
  if (!instructions_.use(line)) {
    const uint64_t ready = line == prefetched_ ? prefetch_ends_ : now + profile_.wait;
    waited = ready > now ? ready - now : 0;
  }
  if (profile_.prefetches != 0 && !instructions_.has(line + 1)) {
    prefetched_ = line + 1;
    prefetch_ends_ = now + waited + profile_.wait + 1;
  }
  return waited;
}

uint64_t Flash::fetch(uint64_t first, uint64_t after, uint64_t now, uint64_t cycles) {
  if (!holds(first)) {
    return 0;
  }
  const uint64_t from = first / profile_.line_bytes;
  const uint64_t to = (after - 1) / profile_.line_bytes;
  uint64_t waited = 0;
  for (uint64_t line = from; line <= to; ++line) {
    if (line != line_) {
      const uint64_t executed = (line - from) * cycles / (to - from + 1);
      waited += fetch_line(line, now + waited + executed);
      line_ = line;
    }
  }
  return waited;
}

uint64_t Flash::load(uint64_t address) {
  if (!holds(address)) {
    return 0;
  }
  LineCache& cache = profile_.data_lines == 0 ? instructions_ : data_;
  return cache.use(address / profile_.line_bytes) ? 0 : profile_.wait;
}

}  // namespace cycles
