// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/plugin_process.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <system_error>

#include "fuzz/plugin_server.h"

namespace gnomon::fuzz::plugin {

namespace {

/// To the nursery: start a worker on the two descriptors sent along (pid 0), or end one. Back: pid or status.
struct Message {
  pid_t pid;
  std::int32_t number;  ///< to: milliseconds of grace; back: status of waitpid()
};

/// The two descriptors of a start, as ancillary data of a message.
struct Passed {
  static constexpr std::size_t kCount = 2;
  alignas(cmsghdr) std::array<char, CMSG_SPACE(kCount * sizeof(int))> bytes{};
};

bool send_message(int channel, const Message& message, const int* descriptors) {
  iovec part{const_cast<Message*>(&message), sizeof message};
  msghdr header{};
  header.msg_iov = &part;
  header.msg_iovlen = 1;
  Passed passed;
  if (descriptors != nullptr) {
    header.msg_control = passed.bytes.data();
    header.msg_controllen = passed.bytes.size();
    cmsghdr* const rights = CMSG_FIRSTHDR(&header);
    rights->cmsg_level = SOL_SOCKET;
    rights->cmsg_type = SCM_RIGHTS;
    rights->cmsg_len = CMSG_LEN(Passed::kCount * sizeof(int));
    std::memcpy(CMSG_DATA(rights), descriptors, Passed::kCount * sizeof(int));
  }
  ssize_t sent = 0;
  do sent = ::sendmsg(channel, &header, MSG_NOSIGNAL);
  while (sent < 0 && errno == EINTR);
  return sent == static_cast<ssize_t>(sizeof message);
}

/// False at the end of the channel.
bool receive_message(int channel, Message& message, int* descriptors) {
  iovec part{&message, sizeof message};
  msghdr header{};
  header.msg_iov = &part;
  header.msg_iovlen = 1;
  Passed passed;
  header.msg_control = passed.bytes.data();
  header.msg_controllen = passed.bytes.size();
  ssize_t got = 0;
  do got = ::recvmsg(channel, &header, MSG_CMSG_CLOEXEC);
  while (got < 0 && errno == EINTR);
  const cmsghdr* const rights = CMSG_FIRSTHDR(&header);
  if (descriptors != nullptr && rights != nullptr)
    std::memcpy(descriptors, CMSG_DATA(rights), Passed::kCount * sizeof(int));
  return got == static_cast<ssize_t>(sizeof message);
}

/// Closes everything but the standard three and `kept`.
void keep_only(int kept) {
  if (kept > 3) ::close_range(3, static_cast<unsigned>(kept) - 1, 0);
  ::close_range(static_cast<unsigned>(kept) + 1, ~0u, 0);
}

/// The process dies when its parent does, also when that has happened already.
void die_with(pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(0);
}

[[noreturn]] void become_worker(const std::string& library, FileDescriptor memory, FileDescriptor channel,
                                pid_t nursery) {
  die_with(nursery);
  // Results go to gnomon's standard output: what a plug-in prints joins the messages instead.
  const int null = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  ::dup2(null, STDIN_FILENO);
  ::dup2(STDERR_FILENO, STDOUT_FILENO);
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  try {
    const Region region(memory, Region::Side::plugin);
    memory.reset();
    keep_only(channel.number());
    serve(library, region, channel);
  } catch (const std::system_error&) {
    ::_exit(1);
  }
}

int reap(pid_t pid, int milliseconds) {
  int status = 0;
  for (int waited = 0; waited < milliseconds; ++waited) {
    if (::waitpid(pid, &status, WNOHANG) == pid) return status;
    ::usleep(1000);
  }
  ::kill(pid, SIGKILL);
  while (::waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

[[noreturn]] void tend(const std::string& library, const FileDescriptor& channel) {
  const pid_t self = ::getpid();
  Message message{};
  std::array<int, Passed::kCount> descriptors{-1, -1};
  while (receive_message(channel.number(), message, descriptors.data())) {
    if (message.pid == 0) {
      FileDescriptor memory(descriptors[0]), worker_end(descriptors[1]);
      const pid_t child = ::fork();
      if (child == 0) become_worker(library, std::move(memory), std::move(worker_end), self);
      message.pid = child;
    } else {
      message.number = reap(message.pid, message.number);
    }
    if (!send_message(channel.number(), message, nullptr)) break;
  }
  ::_exit(0);
}

struct Ends {
  FileDescriptor here, there;
};

Ends make_channel(int type) {
  std::array<int, 2> both{};
  if (::socketpair(AF_UNIX, type | SOCK_CLOEXEC, 0, both.data()) != 0)
    throw std::system_error(errno, std::generic_category(), "channel to a plug-in");
  return {FileDescriptor(both[0]), FileDescriptor(both[1])};
}

}  // namespace

Reply wait_for(const Worker& worker, double seconds) {
  using Clock = std::chrono::steady_clock;
  const auto limit = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  const Clock::time_point deadline = Clock::now() + limit;
  pollfd event{worker.channel.number(), POLLIN, 0};
  for (;;) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
    if (left <= 0) return Reply::timed_out;
    const int ready = ::poll(&event, 1, static_cast<int>(std::min<long long>(left, 1'000'000)));
    if (ready <= 0) continue;
    char byte = 0;
    const ssize_t got = ::recv(worker.channel.number(), &byte, 1, MSG_DONTWAIT);
    if (got < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    return got == 1 && byte == kReady ? Reply::ready : Reply::ended;
  }
}

Reply ask(const Worker& worker, double seconds) {
  if (::send(worker.channel.number(), &kRun, 1, MSG_NOSIGNAL) != 1) return Reply::ended;
  return wait_for(worker, seconds);
}

Nursery::Nursery(std::string library) {
  Ends ends = make_channel(SOCK_SEQPACKET);
  std::fflush(nullptr);  // else the fork may print it too
  const pid_t self = ::getpid();
  pid_ = ::fork();
  if (pid_ < 0) throw std::system_error(errno, std::generic_category(), "process for a plug-in");
  if (pid_ == 0) {
    die_with(self);
    keep_only(ends.there.number());
    tend(library, ends.there);
  }
  channel_ = std::move(ends.here);
}

Nursery::~Nursery() {
  if (pid_ > 0) reap(pid_, 0);
}

std::unique_ptr<Worker> Nursery::start() {
  const FileDescriptor memory = Region::make();
  Ends ends = make_channel(SOCK_STREAM);
  const std::array<int, Passed::kCount> descriptors{memory.number(), ends.there.number()};
  Message message{0, 0};
  {
    const std::lock_guard lock(mutex_);
    if (!send_message(channel_.number(), message, descriptors.data()) ||
        !receive_message(channel_.number(), message, nullptr) || message.pid <= 0) {
      throw std::system_error(ECHILD, std::generic_category(), "process for a plug-in");
    }
  }
  return std::make_unique<Worker>(message.pid, memory, std::move(ends.here));
}

int Nursery::end(const Worker& worker, bool by_itself) {
  constexpr int kGrace = 2000;
  Message message{worker.pid, by_itself ? kGrace : 0};
  const std::lock_guard lock(mutex_);
  if (!send_message(channel_.number(), message, nullptr) ||
      !receive_message(channel_.number(), message, nullptr)) {
    return SIGKILL;  // the nursery is gone, and its workers with it
  }
  return message.number;
}

}  // namespace gnomon::fuzz::plugin
