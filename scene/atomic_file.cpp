// SPDX-License-Identifier: MIT
#include "scene/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace gnomon::scene {

namespace {

[[noreturn]] void fail(const std::filesystem::path& path, int error) {
  throw std::runtime_error(path.string() + ": can't be written: " + std::strerror(error));
}

bool write_all(int descriptor, std::string_view contents) {
  while (!contents.empty()) {
    const ssize_t written = ::write(descriptor, contents.data(), contents.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    contents.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

/// A new file beside `path`, its name in `temporary`.
int open_temporary(const std::filesystem::path& path, std::string& temporary) {
  std::error_code ignored;
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), ignored);
  temporary = path.string() + ".XXXXXX";
  const int descriptor = ::mkstemp(temporary.data());
  if (descriptor < 0) fail(path, errno);
  return descriptor;
}

}  // namespace

void require_writable(const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) fail(path, EISDIR);
  std::vector<std::filesystem::path> missing;  // folders, the innermost first
  for (auto folder = path.parent_path(); !folder.empty() && !std::filesystem::exists(folder, ignored);
       folder = folder.parent_path()) {
    missing.push_back(folder);
  }
  const auto remove_made = [&] {
    for (const auto& folder : missing) ::rmdir(folder.c_str());
  };
  std::string temporary;
  try {
    ::close(open_temporary(path, temporary));
  } catch (...) {
    remove_made();
    throw;
  }
  ::unlink(temporary.c_str());
  remove_made();
}

void write_whole_file(const std::filesystem::path& path, std::string_view contents) {
  std::string temporary;
  const int descriptor = open_temporary(path, temporary);
  const bool written =
      write_all(descriptor, contents) && ::fchmod(descriptor, 0644) == 0 && ::fsync(descriptor) == 0;
  const int error = errno;
  ::close(descriptor);
  if (!written || ::rename(temporary.c_str(), path.c_str()) != 0) {
    const int why = written ? errno : error;
    ::unlink(temporary.c_str());
    fail(path, why);
  }
}

}  // namespace gnomon::scene
