// SPDX-License-Identifier: GPL-3.0-or-later
// The memory that gnomon shares with a plug-in's process: a request, its cases and its answers.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "fuzz/file_descriptor.h"

namespace gnomon::fuzz::plugin {

/// Cases a call at most: the block size of the trial loop.
inline constexpr std::size_t kMostCases = 1024;
inline constexpr std::size_t kMostMethods = 64;

/// Where a bad access to memory went: what is told of its address.
enum class Place : std::uint32_t { elsewhere, null, cases, answers };

/// What a plug-in says about one method.
struct MethodText {
  std::uint32_t question, promise, has_f32, has_f64;
  std::array<char, 32> name;
  std::array<char, 128> summary;
};

/// How a call, or the loading, ended; as the plug-in's process sees it.
enum class Outcome : std::uint32_t { none, done, refused, threw, changed_modes };

/// Requests and what is not cases and answers. A plug-in may overwrite it: nothing here is believed
/// unchecked.
struct Control {
  // From gnomon.
  std::uint32_t method, is_double, count;
  // From the plug-in's process.
  Outcome outcome;
  Place fault_place;
  std::uint64_t ns;             ///< processor time of the call
  std::array<char, 512> error;  ///< why the plug-in was refused
  std::array<char, 32> name;
  std::uint32_t method_count;
  std::array<MethodText, kMostMethods> methods;
};

/// One region: control, cases and answers, each between guards that can't be read or written. The arrays end
/// where their last page ends, so that one step past the end hits a guard; the bytes before the answers hold
/// a pattern that is checked.
class Region {
 public:
  /// Who maps the region: gnomon, or the plug-in's process, which can't write to the cases.
  enum class Side : std::uint8_t { gnomon, plugin };

  /// Makes the memory. Throws std::system_error.
  [[nodiscard]] static FileDescriptor make();
  Region(const FileDescriptor& memory, Side side);
  ~Region();
  Region(const Region&) = delete;
  Region& operator=(const Region&) = delete;

  [[nodiscard]] Control& control() const { return *control_; }
  /// The arrays of a request: `bytes` of cases, `count` answers.
  [[nodiscard]] std::byte* cases(std::size_t bytes) const { return cases_end_ - bytes; }
  [[nodiscard]] std::span<std::uint8_t> answers(std::size_t count) const {
    return {answers_end_ - count, count};
  }
  /// Fills the answers with kUnwritten and what lies before them with a pattern; false when that has changed.
  void prepare_answers(std::size_t count) const;
  [[nodiscard]] bool pattern_holds(std::size_t count) const;
  /// Where an address of this process lies: within the arrays or their guards.
  [[nodiscard]] Place place_of(std::uint64_t address) const;

  static constexpr std::uint8_t kUnwritten = 0xEE;

 private:
  std::byte* base_ = nullptr;
  Control* control_ = nullptr;
  std::byte *cases_begin_ = nullptr, *cases_end_ = nullptr;
  std::uint8_t *answers_begin_ = nullptr, *answers_end_ = nullptr;
};

}  // namespace gnomon::fuzz::plugin
