// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a result file: rows, or a complaint of one line.
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "fuzz/targets/complaint.h"
#include "reports/result_reader.h"
#include "scene/input_error.h"

namespace {

/// The file that inputs pass through, in a folder of this process.
std::filesystem::path file() {
  static const std::filesystem::path path = [] {
    std::string name = (std::filesystem::temp_directory_path() / "gnomon-results.XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) std::abort();
    static const std::string folder = name;
    std::atexit([] { std::filesystem::remove_all(folder); });
    return std::filesystem::path(folder) / "input.json";
  }();
  return path;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gnomon;
  std::ofstream(file(), std::ios::binary)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  try {
    (void)reports::read_result_file(file());
  } catch (const scene::InputError& error) {
    fuzz::expect_complaint(error.what(), file().string());
  }
  return 0;
}
