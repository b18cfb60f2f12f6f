#include "files/child_process.hpp"

#include "files/ending_signals.hpp"

#include <mdm/text/error.hpp>

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <utility>

namespace mdm {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

[[noreturn]] void cannot_start(int error) {
  throw InputError(std::string("a program cannot be started: ") + std::strerror(error) +
                   ": try again with fewer at once");
}

/// A file descriptor that is closed with the object.
class Descriptor {
public:
  Descriptor() = default;
  explicit Descriptor(int number) : number_(number) {
    if (number < 0)
      cannot_start(errno);
  }
  Descriptor(Descriptor &&other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor &operator=(Descriptor &&other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() { reset(); }
  void reset() {
    if (number_ >= 0)
      close(std::exchange(number_, -1));
  }
  int operator*() const { return number_; }

private:
  int number_ = -1;
};

/// The reading end does not block.
struct Pipe {
  Descriptor read, write;

  Pipe() {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0)
      cannot_start(errno);
    read = Descriptor(ends[0]);
    write = Descriptor(ends[1]);
    fcntl(*read, F_SETFL, O_NONBLOCK);
  }
};

/// A file in memory in place of a pipe: a program that does not read it cannot block or break its writer.
Descriptor file_with(std::string_view text) {
  Descriptor file(memfd_create("mdm-input", MFD_CLOEXEC));
  while (!text.empty()) {
    const ssize_t n = write(*file, text.data(), text.size());
    if (n < 0 && errno != EINTR)
      cannot_start(errno);
    text.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(n, 0)));
  }
  lseek(*file, 0, SEEK_SET);
  return file;
}

/// The process groups that run, for the signal handler; 0: a free place.
std::array<std::atomic<pid_t>, 2048> running;
std::atomic<int> dying = 0; // of bool not each machine has one without a lock
static_assert(std::atomic<pid_t>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

void kill_children() {
  dying = 1;
  for (const std::atomic<pid_t> &group : running)
    if (const pid_t g = group; g != 0)
      kill(-g, SIGKILL);
}

/// Between fork and exec: only what is safe there.
[[noreturn]] void become(const char *command, int input, int output, int errors, pid_t parent) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL); // should this program be killed itself
  if (getppid() != parent)
    _exit(127);
  dup2(input, STDIN_FILENO);
  dup2(output, STDOUT_FILENO);
  dup2(errors, STDERR_FILENO);
  for (const int signal : {SIGPIPE, SIGXFSZ}) // ignored here, which exec would keep
    std::signal(signal, SIG_DFL);
  execl("/bin/sh", "sh", "-c", command, static_cast<char *>(nullptr));
  _exit(127);
}

/// A running shell in a process group of its own. It ends with the object.
class Child {
public:
  Child(const std::string &command, int input, int output, int errors) {
    const pid_t parent = getpid();
    id_ = fork();
    if (id_ < 0)
      cannot_start(errno);
    if (id_ == 0)
      become(command.c_str(), input, output, errors, parent);
    setpgid(id_, id_); // whoever is first, child or parent
    for (std::atomic<pid_t> &place : running) {
      pid_t none = 0;
      if (place.compare_exchange_strong(none, id_)) {
        place_ = &place;
        break;
      }
    }
  }
  Child(const Child &) = delete;
  Child &operator=(const Child &) = delete;
  ~Child() {
    // Not reaped yet, the child keeps its number: the group is its own and no other's.
    kill(-id_, SIGKILL);
    if (place_ != nullptr)
      *place_ = 0;
    while (waitpid(id_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }

  /// True if it has ended: `end` says how.
  bool has_ended(ChildEnd &end) const {
    siginfo_t info{};
    if (waitid(P_PID, static_cast<id_t>(id_), &info, WEXITED | WNOHANG | WNOWAIT) != 0 || info.si_pid == 0)
      return false;
    end.how = info.si_code == CLD_EXITED ? ChildEnd::How::exited : ChildEnd::How::signalled;
    end.code = info.si_status;
    return true;
  }

private:
  pid_t id_ = 0;
  std::atomic<pid_t> *place_ = nullptr;
};

/// Appends what is there, up to a megabyte; closes the descriptor at its end.
void take(Descriptor &from, std::string &text) {
  std::array<char, 1 << 16> part;
  for (unsigned parts = 0; parts < 16 && *from >= 0; ++parts) {
    const ssize_t n = read(*from, part.data(), part.size());
    if (n < 0 && errno != EINTR)
      return;
    if (n == 0)
      from.reset();
    text.append(part.data(), static_cast<std::size_t>(std::max<ssize_t>(n, 0)));
  }
}

void keep_end(std::string &text) {
  constexpr std::size_t kept = 4096;
  if (text.size() > kept)
    text.erase(0, text.size() - kept);
}

std::string last_line(std::string text) {
  text.erase(text.find_last_not_of(" \t\r\n") + 1);
  return text.substr(text.rfind('\n') + 1);
}

} // namespace

ChildEnd run_child(const std::string &command, std::string_view input, milliseconds time_limit,
                   std::size_t most_output) {
  // Children are in groups of their own and would not see what ends this program.
  [[maybe_unused]] static const bool are_killed_with_this = (before_ending_signals(kill_children), true);
  const Clock::time_point deadline = Clock::now() + time_limit;
  const Descriptor standard_input = file_with(input);
  Pipe output, errors;
  ChildEnd end;
  std::string error_text;
  {
    const Child child(command, *standard_input, *output.write, *errors.write);
    output.write.reset();
    errors.write.reset();
    const auto take_all = [&] {
      take(output.read, end.output);
      take(errors.read, error_text);
      keep_end(error_text);
    };
    // Its end is looked for again and again: its pipes need not tell, as they may be closed before or open in
    // a child of its own after it.
    constexpr milliseconds longest_nap(20);
    for (milliseconds nap(1);;) {
      const bool ended = child.has_ended(end);
      take_all();
      if (end.output.size() > most_output) {
        end.how = ChildEnd::How::too_much_output;
        break;
      }
      if (ended) // and a pipe holds no more than was just taken
        break;
      const milliseconds left = std::chrono::ceil<milliseconds>(deadline - Clock::now());
      if (left.count() <= 0) {
        end.how = ChildEnd::How::timed_out;
        break;
      }
      std::array<pollfd, 2> waiting = {{{*output.read, POLLIN, 0}, {*errors.read, POLLIN, 0}}};
      const int ready = poll(waiting.data(), waiting.size(), static_cast<int>(std::min(left, nap).count()));
      nap = ready > 0 ? milliseconds(1) : std::min(2 * nap, longest_nap);
    }
  }
  while (dying != 0) // this end is none of the child's own: nobody may see it
    pause();
  end.last_error = last_line(std::move(error_text));
  return end;
}

} // namespace mdm
