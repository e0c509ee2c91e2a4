// SPDX-License-Identifier: GPL-3.0-or-later
// Random numbers for the shaft tests, the same on every platform, and how many of them a build can afford.
#pragma once

#include <cstdint>
#include <cstdlib>

namespace gnomon::tests {

/// SplitMix64 (Steele, Lea, Flood: "Fast splittable pseudorandom number generators", 2014). One seed, one
/// sequence; own bits-to-float code, because the standard leaves its distributions open.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  /// Uniform in 0 .. n-1.
  int below(int n) { return static_cast<int>(((bits() >> 32) * static_cast<std::uint64_t>(n)) >> 32); }
  /// Uniform in lo .. hi, both included.
  int between(int lo, int hi) { return lo + below(hi - lo + 1); }
  bool chance(int percent) { return below(100) < percent; }
  /// Uniform multiples of 2^-53 in [0, 1).
  double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }

 private:
  std::uint64_t state_;
};

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kSanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer)
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif
#else
inline constexpr bool kSanitized = false;
#endif

/// How many of `count` trials this build runs: sanitizers are 5 to 20 times slower.
constexpr int affordable(int count) {
  return kSanitized ? count / 8 : count;
}

/// The number of cases that the environment asks for by GNOMON_REFERENCE_CASES, else `otherwise`.
inline int reference_cases(int otherwise) {
  const char* const asked = std::getenv("GNOMON_REFERENCE_CASES");
  const int cases = asked == nullptr ? 0 : std::atoi(asked);
  return cases > 0 ? cases : otherwise;
}

}  // namespace gnomon::tests
