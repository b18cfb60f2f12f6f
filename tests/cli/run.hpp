#pragma once
/// \file
/// Runs the project's programs as a user does, and looks at all that comes out.

#include "catch.hpp"
#include "files.hpp"
#include "sanitizers.hpp"

#include <sys/types.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace cli_test {

using Arguments = std::vector<std::string>;
using mdm_test::read_file;
using mdm_test::TemporaryFolder;

struct Outcome {
  int exit_code = -1; // -1: ended by a signal
  int signal = 0;
  std::string out, err;
  long max_rss_kib = 0;
};

/// A program that runs; its standard input is a pipe that is written to, its output and errors go to files.
class Process {
public:
  static constexpr std::chrono::seconds time_limit{300};

  /// `output` and `errors` are where standard output and standard error go: "" (kept, see end()), a file,
  /// "closed pipe", a pipe without a reader, or "nowhere", a descriptor that is not open.
  Process(const std::string &program, const Arguments &arguments, const std::string &output = "",
          const std::string &errors = "");
  ~Process();
  Process(const Process &) = delete;
  Process &operator=(const Process &) = delete;

  /// Writes to the standard input; what a program that has ended does not read is dropped.
  void send(const std::string &text);
  void close_input();
  void signal(int number) const;
  /// What is on standard output by now.
  std::string out() const;
  /// Waits until standard output has so many lines; false if the time limit comes first.
  bool wait_for_lines(std::ptrdiff_t lines) const;
  Outcome end();

private:
  TemporaryFolder folder_;
  bool keeps_output_, keeps_errors_;
  pid_t child_ = -1;
  int input_ = -1;
};

Outcome mdm(const Arguments &arguments, const std::string &standard_input = "",
            const std::string &output = "", const std::string &errors = "");
Outcome mdm_check(const std::string &gradation, const std::string &proof);
/// The same of a gradation, a sample and its certificate.
Outcome mdm_check(const Arguments &files);
/// The lines of a text, without their ends.
std::vector<std::string> lines_of(const std::string &text);
/// True if the part is in the text; a check that fails shows both.
bool contains(const std::string &text, const std::string &part);
/// The path of one of the real gradations.
std::string example(const std::string &name);
/// Exit 2, a message in one line of clean text, nothing on standard output.
void check_refused(const Outcome &outcome, const std::string &part_of_message = "");

} // namespace cli_test
