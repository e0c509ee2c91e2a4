// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/environment.h"

#include <fstream>
#include <thread>

#include "fast/fp_environment.h"

namespace gnomon::reports {

namespace {

std::string compiler() {
#if defined(__clang__)
  return std::string("clang ") + __clang_version__;
#else
  return std::string("g++ ") + __VERSION__;
#endif
}

std::string processor() {
  std::ifstream in("/proc/cpuinfo");
  std::string line;
  while (std::getline(in, line)) {
    if (line.rfind("model name", 0) != 0) continue;
    const std::size_t colon = line.find(": ");
    if (colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

}  // namespace

std::string version() {
  return "gnomon " GNOMON_VERSION;
}

std::vector<std::pair<std::string, std::string>> environment() {
  const fast::FpEnvironment fp = fast::witness_fp_environment();
  return {{"compiler", compiler()},
          {"build", GNOMON_BUILD_TYPE},
          {"flags", GNOMON_CXX_FLAGS},
          {"cpu", processor()},
          {"hardware_threads", std::to_string(std::thread::hardware_concurrency())},
          {"rounding", fp.rounds_to_nearest ? "to nearest" : "not to nearest"},
          {"contraction", fp.fuses_products ? "on" : "off"},
          {"denormals", fp.keeps_denormals ? "kept" : "flushed"},
          {"excess_precision", fp.excess_precision ? "yes" : "no"}};
}

}  // namespace gnomon::reports
