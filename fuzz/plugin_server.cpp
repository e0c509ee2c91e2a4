// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/plugin_server.h"

#include <dlfcn.h>
#include <sys/resource.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <cfenv>
#include <csignal>
#include <cstring>
#include <ctime>
#ifdef __SSE__
#include <xmmintrin.h>
#endif

#include "fuzz/plugin/gnomon/plugin.h"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define GNOMON_MAPS_MUCH 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define GNOMON_MAPS_MUCH 1
#endif
#endif

namespace gnomon::fuzz::plugin {

namespace {

const Region* watched = nullptr;  // the one region that this process serves

/// Notes where a bad access went; the second fault, with the default action, ends the process.
void on_fault(int, siginfo_t* info, void*) {
  watched->control().fault_place = watched->place_of(reinterpret_cast<std::uint64_t>(info->si_addr));
}

void watch_faults(const Region& region) {
  watched = &region;
  // A plug-in that runs out of stack still has this one to report on.
  alignas(16) static std::array<std::byte, 64 * 1024> stack;
  stack_t other{};
  other.ss_sp = stack.data();
  other.ss_size = stack.size();
  ::sigaltstack(&other, nullptr);
  struct sigaction action {};
  action.sa_sigaction = on_fault;
  action.sa_flags = SA_SIGINFO | SA_ONSTACK | static_cast<int>(SA_RESETHAND);
  ::sigaction(SIGSEGV, &action, nullptr);
  ::sigaction(SIGBUS, &action, nullptr);
}

/// No core files, and no more memory than leaves the machine alive: allocations fail instead.
void limit_resources() {
  const rlimit none{0, 0};
  ::setrlimit(RLIMIT_CORE, &none);
#ifndef GNOMON_MAPS_MUCH  // sanitizers map far more than they use
  constexpr rlim_t kMost = rlim_t{4} << 30;
  const rlimit data{kMost, kMost};
  ::setrlimit(RLIMIT_DATA, &data);
#endif
}

/// The floating-point modes: what loading the plug-in left is what its methods run under, each time.
struct Modes {
  std::fenv_t all;
  int rounding;
  unsigned denormals = 0;

  static Modes now() {
    Modes modes{};
    std::fegetenv(&modes.all);
    modes.rounding = std::fegetround();
#ifdef __SSE__
    modes.denormals = _mm_getcsr() & 0x8040u;  // flush to zero, denormals are zero
#endif
    return modes;
  }
  [[nodiscard]] bool same_as(const Modes& other) const {
    return rounding == other.rounding && denormals == other.denormals;
  }
};

template <std::size_t N>
void copy_text(std::array<char, N>& to, const char* from) {
  to.fill(0);
  std::strncpy(to.data(), from, N - 1);
}

/// Ends the process with the reason why the plug-in can't be used.
[[noreturn]] void refuse(Control& control, const FileDescriptor& channel, const std::string& why) {
  copy_text(control.error, why.c_str());
  control.outcome = Outcome::refused;
  [[maybe_unused]] const ssize_t sent = ::send(channel.number(), &kReady, 1, MSG_NOSIGNAL);
  ::_exit(0);
}

bool is_name(const char* name) {
  const std::size_t length = name == nullptr ? 0 : ::strnlen(name, 32);
  return length >= 1 && length <= 31 && std::all_of(name, name + length, [](char c) {
           return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
         });
}

std::string objection_to(const gnomon_plugin& plugin) {
  if (plugin.abi != GNOMON_PLUGIN_ABI) {
    return "speaks version " + std::to_string(plugin.abi) +
           " of gnomon/plugin.h, this gnomon speaks version " + std::to_string(GNOMON_PLUGIN_ABI);
  }
  if (plugin.size < sizeof(gnomon_plugin) || plugin.method_size < sizeof(gnomon_method) ||
      plugin.method_size % alignof(gnomon_method) != 0) {
    return "states sizes that no version of gnomon/plugin.h has (size, method_size)";
  }
  if (plugin.method_count < 1 || plugin.method_count > kMostMethods || plugin.methods == nullptr)
    return "expected 1 to 64 methods, found " + std::to_string(plugin.method_count);
  if (!is_name(plugin.name)) return "expected a name of 1 to 31 characters a-z 0-9 - _";
  return {};
}

std::string objection_to(const gnomon_method& method, unsigned index) {
  const std::string which = "method " + std::to_string(index) + ": ";
  if (!is_name(method.name)) return which + "expected a name of 1 to 31 characters a-z 0-9 - _";
  const std::string named = "method " + std::string(method.name) + ": ";
  if (method.question != GNOMON_SHAFT_BOX && method.question != GNOMON_SHAFT_SPHERE)
    return named + "question " + std::to_string(method.question) + " is not known to this gnomon";
  if (method.promise > GNOMON_ALWAYS_AGREES)
    return named + "promise " + std::to_string(method.promise) + " is not known to this gnomon";
  if (method.run_f32 == nullptr && method.run_f64 == nullptr)
    return named + "has neither run_f32 nor run_f64";
  return {};
}

/// The table of a loaded plug-in; methods may be larger than this gnomon knows them.
class Table {
 public:
  explicit Table(const gnomon_plugin& plugin) : plugin_(plugin) {}
  [[nodiscard]] const gnomon_method& method(unsigned index) const {
    const auto* const bytes = reinterpret_cast<const char*>(plugin_.methods);
    return *reinterpret_cast<const gnomon_method*>(bytes + std::size_t{index} * plugin_.method_size);
  }

 private:
  const gnomon_plugin& plugin_;
};

const gnomon_plugin& load(const std::string& library, Control& control, const FileDescriptor& channel) {
  void* const handle = ::dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) {
    const char* const why = ::dlerror();
    refuse(control, channel, std::string("can't be loaded: ") + (why != nullptr ? why : "?"));
  }
  using Entry = const gnomon_plugin*();
  auto* const entry = reinterpret_cast<Entry*>(::dlsym(handle, "gnomon_plugin_entry"));
  if (entry == nullptr) refuse(control, channel, "exports no gnomon_plugin_entry(): no plug-in of gnomon's");
  const gnomon_plugin* const plugin = entry();
  if (plugin == nullptr)
    refuse(control, channel, "says that it can't run here (gnomon_plugin_entry() is null)");
  const std::string objection = objection_to(*plugin);
  if (!objection.empty()) refuse(control, channel, objection);
  return *plugin;
}

void describe(const gnomon_plugin& plugin, Control& control, const FileDescriptor& channel) {
  const Table table(plugin);
  copy_text(control.name, plugin.name);
  for (unsigned i = 0; i < plugin.method_count; ++i) {
    const gnomon_method& method = table.method(i);
    const std::string objection = objection_to(method, i);
    if (!objection.empty()) refuse(control, channel, objection);
    MethodText& text = control.methods[i];
    text = {method.question, method.promise, method.run_f32 != nullptr, method.run_f64 != nullptr, {}, {}};
    copy_text(text.name, method.name);
    if (method.summary != nullptr) copy_text(text.summary, method.summary);
  }
  control.method_count = plugin.method_count;
}

/// The processor time of this thread.
std::uint64_t thread_ns() {
  timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<std::uint64_t>(now.tv_sec) * 1'000'000'000 + static_cast<std::uint64_t>(now.tv_nsec);
}

Outcome run(const gnomon_method& method, const Region& region, bool is_double, std::size_t count) {
  const std::size_t numbers = count * (method.question == GNOMON_SHAFT_BOX ? 18 : 16);
  unsigned char* const answers = region.answers(count).data();
  try {
    if (is_double) {
      method.run_f64(count, reinterpret_cast<const double*>(region.cases(numbers * sizeof(double))), answers,
                     method.user);
    } else {
      method.run_f32(count, reinterpret_cast<const float*>(region.cases(numbers * sizeof(float))), answers,
                     method.user);
    }
  } catch (...) {
    return Outcome::threw;
  }
  return Outcome::done;
}

}  // namespace

void serve(const std::string& library, const Region& region, const FileDescriptor& channel) {
  Control& control = region.control();
  limit_resources();
  watch_faults(region);
  const gnomon_plugin& plugin = load(library, control, channel);
  describe(plugin, control, channel);
  const Table table(plugin);
  const Modes modes = Modes::now();
  control.outcome = Outcome::done;
  char byte = kReady;
  while (::send(channel.number(), &byte, 1, MSG_NOSIGNAL) == 1) {
    ssize_t got = 0;
    do got = ::recv(channel.number(), &byte, 1, 0);
    while (got < 0 && errno == EINTR);
    if (got != 1 || byte != kRun) break;
    // What the plug-in does to the request from here on is its own affair.
    const std::size_t count = control.count;
    const gnomon_method& method = table.method(control.method);
    const bool is_double = control.is_double != 0;
    std::fesetenv(&modes.all);
    const std::uint64_t start = thread_ns();
    Outcome outcome = run(method, region, is_double, count);
    const std::uint64_t end = thread_ns();
    if (outcome == Outcome::done && !Modes::now().same_as(modes)) outcome = Outcome::changed_modes;
    std::fesetenv(&modes.all);
    control.outcome = outcome;
    control.ns = end - start;
    byte = kReady;
  }
  ::_exit(0);
}

}  // namespace gnomon::fuzz::plugin
