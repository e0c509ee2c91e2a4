// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/plugin_calls.h"

#include <sys/wait.h>

#include <algorithm>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "fuzz/generator.h"
#include "scene/float_text.h"

namespace gnomon::fuzz::plugin {

namespace {

/// Text out of a plug-in's hands: bounded, on one line, printable.
template <std::size_t N>
std::string text_of(const std::array<char, N>& bytes) {
  std::string text(bytes.data(), ::strnlen(bytes.data(), N));
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = ' ';
  }
  return text;
}

std::string signal_name(int signal) {
  const char* const name = ::sigabbrev_np(signal);
  return name != nullptr ? "SIG" + std::string(name) : "signal " + std::to_string(signal);
}

std::string place_text(Place place) {
  switch (place) {
    case Place::null:
      return ", a null pointer";
    case Place::cases:
      return ", beyond its cases or writing to them";
    case Place::answers:
      return ", beyond its answers";
    case Place::elsewhere:
      break;
  }
  return {};
}

/// dlopen() looks up names without a slash elsewhere; files are meant here.
std::string file_of(const std::string& path) {
  return std::filesystem::absolute(path).string();
}

}  // namespace

Host::Host(const std::string& path, double seconds) : seconds_(seconds), nursery_(file_of(path)) {
  const auto fail = [&path](const std::string& why) { throw UsageError("--plugin " + path + ": " + why); };
  std::unique_ptr<Worker> worker = nursery_.start();
  if (const std::optional<std::string> why = not_loaded(*worker)) fail(*why);
  read_description(worker->region.control());
  for (std::size_t i = 0; i < methods_.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (methods_[i].question == methods_[j].question && methods_[i].name == methods_[j].name)
        fail("has two methods named " + methods_[i].name);
    }
  }
  idle_.push_back(std::move(worker));
}

std::optional<std::string> Host::not_loaded(const Worker& worker) {
  const Reply reply = wait_for(worker, seconds_);
  const Control& control = worker.region.control();
  if (reply == Reply::ready && control.outcome == Outcome::done) return std::nullopt;
  const std::string why = reply == Reply::ready ? text_of(control.error) : how_it_ended(worker, reply);
  if (reply == Reply::ready) nursery_.end(worker, true);
  return reply == Reply::ready ? why : why + " while it was loaded";
}

void Host::read_description(const Control& control) {
  name_ = text_of(control.name);
  for (std::size_t i = 0; i < std::min<std::size_t>(control.method_count, kMostMethods); ++i) {
    const MethodText& text = control.methods[i];
    methods_.push_back({text.question, text.promise, text.has_f32 != 0, text.has_f64 != 0,
                        name_ + ":" + text_of(text.name), text_of(text.summary)});
  }
}

std::unique_ptr<Worker> Host::take() {
  const std::lock_guard lock(mutex_);
  if (idle_.empty()) return nullptr;
  std::unique_ptr<Worker> worker = std::move(idle_.back());
  idle_.pop_back();
  return worker;
}

std::optional<std::string> Host::call(Call& call) try {
  std::unique_ptr<Worker> worker = take();
  if (worker == nullptr) {
    worker = nursery_.start();
    if (const std::optional<std::string> why = not_loaded(*worker)) return why;
  }
  const Region& region = worker->region;
  Control& control = region.control();
  control.method = call.method;
  control.is_double = call.is_double;
  control.count = static_cast<std::uint32_t>(call.answers.size());
  control.fault_place = Place::elsewhere;
  control.outcome = Outcome::none;
  std::memcpy(region.cases(call.cases.size()), call.cases.data(), call.cases.size());
  region.prepare_answers(call.answers.size());
  const Reply reply = ask(*worker, seconds_);
  if (reply != Reply::ready) return how_it_ended(*worker, reply);
  if (std::optional<std::string> why = complaint(region, call.answers)) {
    nursery_.end(*worker, false);
    return why;
  }
  call.ns = static_cast<double>(control.ns);
  const std::lock_guard lock(mutex_);
  idle_.push_back(std::move(worker));
  return std::nullopt;
} catch (const std::system_error&) {
  return "has no process any more";
}

std::optional<std::string> Host::complaint(const Region& region, std::span<Answer> answers) {
  const Outcome outcome = region.control().outcome;
  if (outcome == Outcome::threw) return "threw an exception";
  if (outcome == Outcome::changed_modes)
    return "left the floating-point modes changed (rounding or denormals)";
  if (outcome != Outcome::done) return "wrote into gnomon's own memory";
  if (!region.pattern_holds(answers.size())) return "wrote before its answers";
  const std::span<const std::uint8_t> given = region.answers(answers.size());
  std::copy(given.begin(), given.end(), answers.begin());
  const auto bad = std::find_if(answers.begin(), answers.end(), [](Answer a) { return a > kRejected; });
  if (bad == answers.end()) return std::nullopt;
  if (*bad == Region::kUnwritten) return "left an answer unwritten";
  return "answered " + std::to_string(*bad) + ", which is no answer (0 to 4)";
}

std::string Host::how_it_ended(const Worker& worker, Reply reply) {
  if (reply == Reply::timed_out) {
    nursery_.end(worker, false);
    return "took longer than " + scene::decimal_text(seconds_) + " s";
  }
  const int status = nursery_.end(worker, true);
  if (WIFEXITED(status)) return "ended its process (exit status " + std::to_string(WEXITSTATUS(status)) + ")";
  const int signal = WTERMSIG(status);
  const bool bad_access = signal == SIGSEGV || signal == SIGBUS;
  // Where it went is told by what lies there, not by its number: that differs from run to run.
  return (signal == SIGKILL ? "was killed (" : "crashed (") + signal_name(signal) +
         (bad_access ? place_text(worker.region.control().fault_place) : "") + ")";
}

}  // namespace gnomon::fuzz::plugin
