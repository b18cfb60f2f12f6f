#pragma once

#include "files.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

namespace mdm_check_test {

inline std::filesystem::path write_file(const std::filesystem::path &path, const std::string &text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  if (!file.flush())
    throw std::runtime_error("cannot write " + path.string());
  return path;
}

using mdm_test::read_file;
using mdm_test::TemporaryFolder;

struct Outcome {
  int exit_code; ///< 128 + signal where a signal ended the program
  std::string out, err;
};

/// Runs mdm-check. The files of standard input and output may be given; "closed pipe" is a pipe without a
/// reader.
inline Outcome run(const std::vector<std::string> &arguments, const std::string &standard_input = "/dev/null",
                   const std::string &standard_output = "") {
  const TemporaryFolder folder;
  const std::string err = (folder.path() / "err").string();
  const std::string out = standard_output.empty() ? (folder.path() / "out").string() : standard_output;
  std::vector<std::string> words{MDM_CHECK_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char *> pointers;
  for (std::string &word : words)
    pointers.push_back(word.data());
  pointers.push_back(nullptr);

  const pid_t child = fork();
  if (child < 0)
    throw std::runtime_error("cannot fork");
  if (child == 0) {
    int out_descriptor = -1;
    if (out == "closed pipe") {
      int ends[2];
      if (pipe(ends) == 0) {
        close(ends[0]);
        out_descriptor = ends[1];
      }
    } else {
      out_descriptor = open(out.c_str(), O_WRONLY | O_CREAT, 0600);
    }
    dup2(open(standard_input.c_str(), O_RDONLY), STDIN_FILENO);
    dup2(out_descriptor, STDOUT_FILENO);
    dup2(open(err.c_str(), O_WRONLY | O_CREAT, 0600), STDERR_FILENO);
    execv(pointers[0], pointers.data());
    _exit(127);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
          standard_output.empty() ? read_file(out) : std::string(), read_file(err)};
}

} // namespace mdm_check_test
