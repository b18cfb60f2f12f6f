#pragma once

#include "answers.hpp"
#include "program_files.hpp"

#include <functional>
#include <map>
#include <memory>
#include <vector>

namespace mdm::checker {

/// Judges the certificate of a sample that is in a file. Throws std::runtime_error where that cannot be read.
Verdict check_sample_file(const Input &gradation, const std::string &sample, const Input &certificate);

/// How many certificates are judged.
struct Manner {
  bool verbose = false; ///< accepted ones are written, too
  unsigned threads = 1;
};

/// The verdicts on many certificates, as they are written and counted. Some are judged at a time, by several
/// threads; they are written in the order in which they were given.
class Verdicts {
public:
  explicit Verdicts(const Manner &manner) : manner_(manner) {}

  /// Judges a certificate that is in memory, as its sample is; or it is read when its turn comes, from
  /// NAME.proof, and one of a sample with NAME.sample.csv. Throws std::runtime_error where standard output
  /// cannot be written, as those below do. An accepted one is compared with the answer, if there is one.
  void check(Input gradation, Input certificate, SharedAnswer answer = {});
  void check_sample(Input gradation, Input sample, Input certificate);
  void check_file(Input gradation, const std::string &certificate, SharedAnswer answer = {});
  void malformed(const std::string &reason);
  void missing(const std::string &what);

  /// Writes the numbers of all, which are of `what`, with the distinct questions of those that are accepted,
  /// and returns the worst code; a missing certificate, and one of another answer, count as refused. Throws
  /// std::runtime_error where there was nothing to judge.
  int end(const std::string &what);

private:
  enum Kind { accepted, refused, malformed_, missing_, different, kinds };
  struct Line {
    Kind kind;
    std::string text, question = {};
  };
  using Job = std::function<Line()>;

  static Line line_of(Verdict verdict);
  static Line judged(const Input &gradation, const Input &certificate, const SharedAnswer &answer);
  std::string questions() const;
  void add(std::size_t bytes, Job job);
  void write_all();

  Manner manner_;
  std::vector<Job> waiting_;
  std::size_t waiting_bytes_ = 0;
  std::uint64_t counts_[kinds] = {};
  bool has_answers_ = false;
  std::map<std::string, std::uint64_t> questions_; ///< of the accepted ones, with their numbers
};

} // namespace mdm::checker
