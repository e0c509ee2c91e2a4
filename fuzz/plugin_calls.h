// SPDX-License-Identifier: GPL-3.0-or-later
// One plug-in, whatever its questions: its processes, and calls that end well or with the reason why not.
#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fuzz/plugin_process.h"
#include "fuzz/verdict.h"

namespace gnomon::fuzz::plugin {

/// One method of a plug-in, as it was described and checked.
struct Description {
  unsigned question, promise;
  bool has_f32, has_f64;
  std::string name;  ///< "PLUGIN:METHOD"
  std::string summary;
};

/// One call: at most kMostCases cases as plain numbers, and where their answers go.
struct Call {
  unsigned method;
  bool is_double;
  std::span<const std::byte> cases;
  std::span<Answer> answers;
  double ns = 0;  ///< processor time that it took, as the plug-in's process says
};

class Host {
 public:
  /// Loads the plug-in. Throws UsageError "--plugin PATH: ...".
  Host(const std::string& path, double seconds);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const std::vector<Description>& methods() const { return methods_; }
  /// The limit of a call and of loading.
  [[nodiscard]] double seconds() const { return seconds_; }

  /// Nothing, or why there are no answers: "crashed (SIGSEGV, past its answers)". Safe from any thread.
  [[nodiscard]] std::optional<std::string> call(Call& call);

 private:
  [[nodiscard]] std::unique_ptr<Worker> take();
  [[nodiscard]] std::optional<std::string> not_loaded(const Worker& worker);
  [[nodiscard]] static std::optional<std::string> complaint(const Region& region, std::span<Answer> answers);
  [[nodiscard]] std::string how_it_ended(const Worker& worker, Reply reply);
  void read_description(const Control& control);

  double seconds_;
  std::string name_;
  std::vector<Description> methods_;
  Nursery nursery_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<Worker>> idle_;
};

}  // namespace gnomon::fuzz::plugin
