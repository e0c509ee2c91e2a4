// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/plugin_memory.h"

#include <sys/mman.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>

namespace gnomon::fuzz::plugin {

namespace {

// Whole pages of every size in use: 4 KiB to 64 KiB. A guard this wide also stops loops that step over
// arrays.
constexpr std::size_t kPage = 64 * 1024, kGuard = 16 * kPage;
constexpr std::size_t kMostNumbers = 18;  // of a case: shaft-box

constexpr std::size_t whole_pages(std::size_t bytes) {
  return (bytes + kPage - 1) / kPage * kPage;
}
constexpr std::size_t kControl = whole_pages(sizeof(Control));
constexpr std::size_t kCases = whole_pages(kMostCases * kMostNumbers * sizeof(double));
constexpr std::size_t kAnswers = whole_pages(kMostCases);

constexpr std::size_t kControlAt = kGuard;
constexpr std::size_t kCasesAt = kControlAt + kControl + kGuard;
constexpr std::size_t kAnswersAt = kCasesAt + kCases + kGuard;
constexpr std::size_t kTotal = kAnswersAt + kAnswers + kGuard;

// What may precede the answers unnoticed by the guard: checked after each call, so not the whole 64 KiB.
constexpr std::size_t kPattern = 4096;
constexpr int kPatternByte = 0xA5;

[[noreturn]] void fail(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

std::byte* map_at(std::byte* at, std::size_t bytes, int protection, const FileDescriptor& memory,
                  std::size_t offset) {
  void* const mapped =
      ::mmap(at, bytes, protection, MAP_SHARED | MAP_FIXED, memory.number(), static_cast<off_t>(offset));
  if (mapped == MAP_FAILED) fail("memory for a plug-in");
  return static_cast<std::byte*>(mapped);
}

}  // namespace

FileDescriptor Region::make() {
  FileDescriptor memory(::memfd_create("gnomon-plugin", MFD_CLOEXEC));
  if (memory.number() < 0 || ::ftruncate(memory.number(), kControl + kCases + kAnswers) != 0)
    fail("memory for a plug-in");
  return memory;
}

Region::Region(const FileDescriptor& memory, Side side) {
  void* const reserved =
      ::mmap(nullptr, kTotal, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (reserved == MAP_FAILED) fail("memory for a plug-in");
  base_ = static_cast<std::byte*>(reserved);
  constexpr int kBoth = PROT_READ | PROT_WRITE;
  const int cases = side == Side::plugin ? PROT_READ : kBoth;
  control_ = reinterpret_cast<Control*>(map_at(base_ + kControlAt, kControl, kBoth, memory, 0));
  cases_begin_ = map_at(base_ + kCasesAt, kCases, cases, memory, kControl);
  cases_end_ = cases_begin_ + kCases;
  answers_begin_ =
      reinterpret_cast<std::uint8_t*>(map_at(base_ + kAnswersAt, kAnswers, kBoth, memory, kControl + kCases));
  answers_end_ = answers_begin_ + kAnswers;
}

Region::~Region() {
  if (base_ != nullptr) ::munmap(base_, kTotal);
}

void Region::prepare_answers(std::size_t count) const {
  std::memset(answers_end_ - count - kPattern, kPatternByte, kPattern);
  std::memset(answers_end_ - count, kUnwritten, count);
}

bool Region::pattern_holds(std::size_t count) const {
  const std::uint8_t* const end = answers_end_ - count;
  return std::all_of(end - kPattern, end, [](std::uint8_t byte) { return byte == kPatternByte; });
}

Place Region::place_of(std::uint64_t address) const {
  constexpr std::uint64_t kNullPage = 4096;
  const auto at = [this](std::size_t offset) { return reinterpret_cast<std::uint64_t>(base_) + offset; };
  if (address < kNullPage) return Place::null;
  if (address >= at(kCasesAt - kGuard / 2) && address < at(kCasesAt + kCases + kGuard / 2))
    return Place::cases;
  if (address >= at(kAnswersAt - kGuard / 2) && address < at(kTotal)) return Place::answers;
  return Place::elsewhere;
}

}  // namespace gnomon::fuzz::plugin
