#include "machine_memory.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>

// Places are strings: libstdc++ 12's std::filesystem::path ends the process where it gets no memory
// to join or cut one.
namespace rgimp {
namespace {

/// The number after `key` in a file of lines "key number", "key: number kB".
std::optional<double> number_after(const std::string& file, std::string_view key) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string word;
    double number = 0.0;
    if (words >> word >> number && word == key) {
      return number;
    }
  }
  return std::nullopt;
}

/// A limit that is a number; a group without one says "max".
std::optional<double> number_in(const std::string& file) {
  std::ifstream in(file);
  double number = 0.0;
  return in >> number ? std::optional(number) : std::nullopt;
}

/// The files of one version of control groups.
struct GroupFiles {
  std::string mount;
  std::string_view limit;
  std::string_view taken;  ///< a key of memory.stat: memory that cannot be given back
};

/// Of a group and those around it, the least that is left. A container may see its own group as the
/// root, whatever its path is called.
std::optional<double> left_in_group(const GroupFiles& files, std::string group) {
  std::optional<double> least;
  while (true) {
    while (group.ends_with('/')) {
      group.pop_back();
    }
    const std::string place = files.mount + group + "/";
    const auto limit = number_in(place + std::string(files.limit));
    if (limit) {
      const double left = *limit - number_after(place + "memory.stat", files.taken).value_or(0.0);
      least = std::min(left, least.value_or(left));
    }
    if (group.empty()) {
      return least;
    }
    const std::size_t last = group.rfind('/');
    group.erase(last == std::string::npos ? 0 : last);
  }
}

/// A line of /proc/self/cgroup: "0::/path" (version 2), "4:memory:/path" (version 1).
std::optional<double> left_by(std::string_view line, const std::string& root) {
  const std::string mount = root + "/sys/fs/cgroup";
  const std::size_t first = line.find(':');
  const std::size_t second = line.find(':', first + 1);
  if (first == std::string_view::npos || second == std::string_view::npos) {
    return std::nullopt;
  }
  const std::string_view controllers = line.substr(first + 1, second - first - 1);
  const std::string group(line.substr(second + 1));
  if (controllers.empty()) {
    return left_in_group({mount, "memory.max", "anon"}, group);
  }
  return controllers == "memory"
             ? left_in_group({mount + "/memory", "memory.limit_in_bytes", "total_rss"}, group)
             : std::nullopt;
}

}  // namespace

std::optional<double> available_memory(const std::string& root) {
  constexpr double kKibibyte = 1024.0;
  std::optional<double> available = number_after(root + "/proc/meminfo", "MemAvailable:");
  if (available) {
    *available *= kKibibyte;
  }
  std::ifstream groups(root + "/proc/self/cgroup");
  for (std::string line; std::getline(groups, line);) {
    if (const auto left = left_by(line, root)) {
      available = std::min(*left, available.value_or(*left));
    }
  }
  return available;
}

}  // namespace rgimp
