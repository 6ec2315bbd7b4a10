#include "bench/measurements/machine.h"

#include "geometry/world/world.h"

#include <fstream>
#include <thread>

namespace abbe::bench {
namespace {

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name"))
      if (const std::size_t colon = line.find(": "); colon != line.npos)
        return line.substr(colon + 2);
  return "unknown";
}

double load_average() {
  std::ifstream file("/proc/loadavg");
  double load = 0.0;
  file >> load;
  return load;
}

} // namespace

Machine this_machine() {
#ifdef __clang__
  const std::string compiler = "Clang " __VERSION__;
#else
  const std::string compiler = "GCC " __VERSION__;
#endif
  return {processor_name(), static_cast<int>(std::thread::hardware_concurrency()),
          load_average(),   ABBE_VERSION,
          embree_version(), compiler,
          ABBE_BUILD_TYPE,  ABBE_ARCH};
}

} // namespace abbe::bench
