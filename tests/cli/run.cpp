#include "run.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>

namespace cli_test {
namespace {

void redirect(int descriptor, const std::string &target) {
  int ends[2];
  if (target == "nowhere") {
    close(descriptor);
  } else if (target == "closed pipe") {
    if (pipe2(ends, O_CLOEXEC) == 0)
      close(ends[0]);
    dup2(ends[1], descriptor);
  } else {
    dup2(open(target.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600), descriptor);
  }
}

} // namespace

Process::Process(const std::string &program, const Arguments &arguments, const std::string &output,
                 const std::string &errors)
    : keeps_output_(output.empty()), keeps_errors_(errors.empty()) {
  std::vector<std::string> words{program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char *> pointers;
  for (std::string &word : words)
    pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const std::string out = keeps_output_ ? folder_ / "out" : output;
  const std::string err = keeps_errors_ ? folder_ / "err" : errors;
  // A signal may come before the program has opened them.
  for (const std::string &kept : {keeps_output_ ? out : "", keeps_errors_ ? err : ""})
    if (!kept.empty())
      std::ofstream(kept).close();
  int input[2];
  if (pipe2(input, O_CLOEXEC) != 0)
    throw std::runtime_error("cannot make a pipe");
  child_ = fork();
  if (child_ < 0)
    throw std::runtime_error("cannot fork");
  if (child_ == 0) {
    dup2(input[0], STDIN_FILENO);
    redirect(STDOUT_FILENO, out);
    redirect(STDERR_FILENO, err);
    std::signal(SIGPIPE, SIG_DFL);
    // Programs of Open MPI that start at the same time would race for one folder in /tmp.
    setenv("OMPI_MCA_orte_tmpdir_base", (folder_ / ".").c_str(), 1);
    execv(pointers[0], pointers.data());
    _exit(127);
  }
  close(input[0]);
  input_ = input[1];
}

Process::~Process() {
  close_input();
  if (child_ > 0) {
    kill(child_, SIGKILL);
    waitpid(child_, nullptr, 0);
  }
}

void Process::send(const std::string &text) {
  const auto before = std::signal(SIGPIPE, SIG_IGN);
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t n = write(input_, text.data() + done, text.size() - done);
    if (n < 0 && errno != EINTR)
      break;
    done += n > 0 ? static_cast<std::size_t>(n) : 0;
  }
  std::signal(SIGPIPE, before);
}

void Process::close_input() {
  if (input_ >= 0)
    close(input_);
  input_ = -1;
}

void Process::signal(int number) const {
  kill(child_, number);
}

std::string Process::out() const {
  return keeps_output_ && std::filesystem::exists(folder_ / "out") ? read_file(folder_ / "out") : "";
}

bool Process::wait_for_lines(std::ptrdiff_t lines) const {
  const auto deadline = std::chrono::steady_clock::now() + time_limit;
  while (std::chrono::steady_clock::now() < deadline) {
    const std::string text = out();
    if (std::count(text.begin(), text.end(), '\n') >= lines)
      return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return false;
}

Outcome Process::end() {
  close_input();
  const auto deadline = std::chrono::steady_clock::now() + time_limit;
  int status = 0;
  rusage usage{};
  while (wait4(child_, &status, WNOHANG, &usage) == 0) {
    if (std::chrono::steady_clock::now() > deadline)
      kill(child_, SIGKILL);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  child_ = -1;
  Outcome outcome;
  if (WIFEXITED(status))
    outcome.exit_code = WEXITSTATUS(status);
  else
    outcome.signal = WTERMSIG(status);
  outcome.out = out();
  outcome.err = keeps_errors_ ? read_file(folder_ / "err") : "";
  outcome.max_rss_kib = usage.ru_maxrss;
  return outcome;
}

Outcome mdm(const Arguments &arguments, const std::string &standard_input, const std::string &output,
            const std::string &errors) {
  Process process(MDM_PROGRAM, arguments, output, errors);
  process.send(standard_input);
  return process.end();
}

Outcome mdm_check(const std::string &gradation, const std::string &proof) {
  return Process(MDM_CHECK_PROGRAM, {gradation, proof}).end();
}

Outcome mdm_check(const Arguments &files) {
  return Process(MDM_CHECK_PROGRAM, files).end();
}

std::vector<std::string> lines_of(const std::string &text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
    lines.push_back(line);
  return lines;
}

bool contains(const std::string &text, const std::string &part) {
  UNSCOPED_INFO("text: " << text.substr(0, 2000) << "\nexpected: " << part);
  return text.find(part) != std::string::npos;
}

std::string example(const std::string &name) {
  return std::string(MDM_SOURCE_DIR) + "/examples/gradations/" + name + ".csv";
}

void check_refused(const Outcome &outcome, const std::string &part_of_message) {
  INFO(outcome.out.substr(0, 2000) << outcome.err.substr(0, 2000));
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.signal == 0);
  CHECK(outcome.out.empty());
  CHECK(outcome.err.find(part_of_message) != std::string::npos);
  CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  CHECK(outcome.err.size() < 1000);
  CHECK(std::all_of(outcome.err.begin(), outcome.err.end(),
                    [](char c) { return c == '\n' || static_cast<unsigned char>(c) >= ' '; }));
}

} // namespace cli_test
