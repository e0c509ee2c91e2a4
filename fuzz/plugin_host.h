// SPDX-License-Identifier: GPL-3.0-or-later
// Plug-ins: other people's methods as rows next to our own.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "fuzz/method.h"
#include "fuzz/volume_questions.h"

namespace gnomon::fuzz {

namespace plugin {
class Host;
}

/// The methods of the plug-ins that a command names, as rows "PLUGIN:METHOD". They run in processes of their
/// own: whatever a plug-in does there ends in a MethodFailure here, and the next call gets a fresh process.
class Plugins {
 public:
  Plugins();
  ~Plugins();
  Plugins(Plugins&&) noexcept;
  Plugins& operator=(Plugins&&) noexcept;

  /// Loads a shared library made for fuzz/plugin/gnomon/plugin.h. A call, at most 1024 cases, that takes
  /// longer than `seconds` is a failure. Call it on the main thread, before there are others (it forks).
  /// Throws UsageError, one line, for a library that is missing, of another version, or that misbehaves when
  /// it is loaded; also for one whose name another one has.
  void load(const std::string& path, double seconds);

  [[nodiscard]] bool empty() const { return hosts_.empty(); }

  template <class Q>
  [[nodiscard]] std::span<const Method<Q>> methods() const;

 private:
  template <class Q>
  struct Rows;
  template <class Q>
  [[nodiscard]] Rows<Q>& rows() const;

  std::vector<std::unique_ptr<plugin::Host>> hosts_;
  std::unique_ptr<Rows<ShaftBoxQuestion>> box_rows_;
  std::unique_ptr<Rows<ShaftBallQuestion>> ball_rows_;
};

/// The registry's rows of Q, then those of the plug-ins, if any; plug-ins have rows for shaft-box and
/// shaft-sphere only.
template <class Q>
[[nodiscard]] std::vector<const Method<Q>*> all_methods(const Plugins* plugins);
template <>
[[nodiscard]] std::vector<const Method<ShaftSlabsQuestion>*> all_methods(const Plugins* plugins);
template <>
[[nodiscard]] std::vector<const Method<ShaftOrientedBoxQuestion>*> all_methods(const Plugins* plugins);
template <>
[[nodiscard]] std::vector<const Method<ShaftEllipsoidQuestion>*> all_methods(const Plugins* plugins);

}  // namespace gnomon::fuzz
