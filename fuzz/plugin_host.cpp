// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/plugin_host.h"

#include <chrono>
#include <deque>
#include <type_traits>

#include "fuzz/generator.h"
#include "fuzz/method_failure.h"
#include "fuzz/plugin/gnomon/plugin.h"
#include "fuzz/plugin_calls.h"
#include "scene/corpus.h"

namespace gnomon::fuzz {

namespace {

using plugin::Description;
using plugin::Host;

constexpr unsigned question_of(const ShaftBoxQuestion&) {
  return GNOMON_SHAFT_BOX;
}
constexpr unsigned question_of(const ShaftBallQuestion&) {
  return GNOMON_SHAFT_SPHERE;
}

/// One form of one method of a plug-in.
template <class Q, class F>
class PluginRunner : public Runner<typename Q::template CaseOf<F>> {
 public:
  using Case = typename Q::template CaseOf<F>;
  // A case is handed over as the plain numbers that it is, in the order of the text corpus.
  static_assert(std::is_trivially_copyable_v<Case> && sizeof(Case) == Q::number_count * sizeof(F));

  PluginRunner(Host& host, unsigned method, std::string name)
      : host_(host), method_(method), name_(std::move(name)) {}

  double run(std::span<const Case> cases, std::span<Answer> answers) const override {
    double ns = 0;
    while (!cases.empty()) {
      const std::size_t count = std::min(cases.size(), plugin::kMostCases);
      plugin::Call call = call_of(cases.first(count), answers.first(count));
      if (const std::optional<std::string> failure = host_.call(call)) blame(*failure, cases.first(count));
      ns += call.ns;
      cases = cases.subspan(count);
      answers = answers.subspan(count);
    }
    return ns;
  }

 private:
  [[nodiscard]] plugin::Call call_of(std::span<const Case> cases, std::span<Answer> answers) const {
    return {method_, std::is_same_v<F, double>, std::as_bytes(cases), answers};
  }

  /// Asks for the cases of a batch one by one, each failure in a fresh process, to name the one to blame.
  [[noreturn]] void blame(const std::string& failure, std::span<const Case> cases) const {
    if (cases.size() == 1)
      throw MethodFailure(name_ + " " + failure + " on " + text_of(cases[0]), {text_of(cases[0])});
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    // A slow plug-in is not waited for 1024 times: as long as the batch might take, and the one that hangs.
    const auto limit = std::chrono::duration<double>(host_.seconds());
    for (std::size_t i = 0; i < cases.size() && Clock::now() - start < limit; ++i) {
      Answer answer = kRejected;
      plugin::Call call = call_of(cases.subspan(i, 1), std::span(&answer, 1));
      if (!host_.call(call)) continue;
      // Whoever killed one process may have killed this one, too: it is the case if that fails once more.
      const std::optional<std::string> again = host_.call(call);
      if (again) throw MethodFailure(name_ + " " + *again + " on " + text_of(cases[i]), {text_of(cases[i])});
    }
    std::vector<std::string> all;
    for (const Case& c : cases) all.push_back(text_of(c));
    const std::string line = name_ + " " + failure + " on a batch of " + std::to_string(cases.size()) +
                             " cases, on no single one of them; the first is " + all.front();
    throw MethodFailure(line, std::move(all));
  }

  [[nodiscard]] static std::string text_of(const Case& c) {
    return scene::corpus_text(Q::id, numbers_of(scene::converted<double>(c)), "");
  }

  Host& host_;
  unsigned method_;
  std::string name_;
};

Promise promise_of(const Description& method) {
  return method.promise == GNOMON_ALWAYS_AGREES   ? Promise::always_agrees
         : method.promise == GNOMON_NEVER_UNSOUND ? Promise::never_unsound
                                                  : Promise::none;
}

}  // namespace

/// The rows of one question. Rows point to runners and to texts, which stay where they are.
template <class Q>
struct Plugins::Rows {
  std::deque<PluginRunner<Q, float>> floats;
  std::deque<PluginRunner<Q, double>> doubles;
  std::vector<Method<Q>> rows;

  void add(Host& host) {
    for (unsigned i = 0; i < host.methods().size(); ++i) {
      const Description& method = host.methods()[i];
      if (method.question != question_of(Q{})) continue;
      Method<Q> row{method.name,
                    "plug-in",
                    promise_of(method),
                    Twin::unknown,
                    method.has_f64 ? "all finite doubles" : "all finite floats",
                    method.summary};
      if (method.has_f32) row.run_f32 = &floats.emplace_back(host, i, method.name);
      if (method.has_f64) row.run_f64 = &doubles.emplace_back(host, i, method.name);
      rows.push_back(row);
    }
  }
};

Plugins::Plugins()
    : box_rows_(std::make_unique<Rows<ShaftBoxQuestion>>()),
      ball_rows_(std::make_unique<Rows<ShaftBallQuestion>>()) {}
Plugins::~Plugins() = default;
Plugins::Plugins(Plugins&&) noexcept = default;
Plugins& Plugins::operator=(Plugins&&) noexcept = default;

template <>
Plugins::Rows<ShaftBoxQuestion>& Plugins::rows() const {
  return *box_rows_;
}
template <>
Plugins::Rows<ShaftBallQuestion>& Plugins::rows() const {
  return *ball_rows_;
}

void Plugins::load(const std::string& path, double seconds) {
  auto host = std::make_unique<Host>(path, seconds);
  for (const std::unique_ptr<Host>& other : hosts_) {
    if (other->name() == host->name())
      throw UsageError("--plugin " + path + ": another plug-in is named " + host->name() + ", too");
  }
  box_rows_->add(*host);
  ball_rows_->add(*host);
  hosts_.push_back(std::move(host));
}

template <class Q>
std::span<const Method<Q>> Plugins::methods() const {
  return rows<Q>().rows;
}

template <class Q>
std::vector<const Method<Q>*> all_methods(const Plugins* plugins) {
  std::vector<const Method<Q>*> all;
  for (const Method<Q>& method : methods<Q>()) all.push_back(&method);
  if (plugins == nullptr) return all;
  for (const Method<Q>& method : plugins->methods<Q>()) all.push_back(&method);
  return all;
}

/// Plug-ins know boxes and balls alone.
template <class Q>
std::vector<const Method<Q>*> own_methods() {
  std::vector<const Method<Q>*> all;
  for (const Method<Q>& method : methods<Q>()) all.push_back(&method);
  return all;
}
template <>
std::vector<const Method<ShaftSlabsQuestion>*> all_methods(const Plugins*) {
  return own_methods<ShaftSlabsQuestion>();
}
template <>
std::vector<const Method<ShaftOrientedBoxQuestion>*> all_methods(const Plugins*) {
  return own_methods<ShaftOrientedBoxQuestion>();
}
template <>
std::vector<const Method<ShaftEllipsoidQuestion>*> all_methods(const Plugins*) {
  return own_methods<ShaftEllipsoidQuestion>();
}

template std::span<const Method<ShaftBoxQuestion>> Plugins::methods() const;
template std::span<const Method<ShaftBallQuestion>> Plugins::methods() const;
template std::vector<const Method<ShaftBoxQuestion>*> all_methods(const Plugins*);
template std::vector<const Method<ShaftBallQuestion>*> all_methods(const Plugins*);

}  // namespace gnomon::fuzz
