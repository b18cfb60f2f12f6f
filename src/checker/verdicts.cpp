#include "verdicts.hpp"

#include "text.hpp"

#include <algorithm>
#include <atomic>
#include <system_error>
#include <thread>
#include <utility>

namespace mdm::checker {
namespace {

/// NAME.sample.csv beside NAME.proof.
std::string sample_beside(const std::string &certificate) {
  return certificate.substr(0, certificate.rfind('.')) + ".sample.csv";
}

} // namespace

Verdict check_sample_file(const Input &gradation, const std::string &sample, const Input &certificate) {
  InputBytes bytes(sample);
  std::size_t taken = 0;
  return check_sample(
      gradation, bytes.name(),
      [&] {
        bytes.take(taken);
        const std::string_view piece = bytes.some();
        taken = piece.size();
        return piece;
      },
      certificate);
}

void Verdicts::check(Input gradation, Input certificate, SharedAnswer answer) {
  const std::size_t bytes = gradation.text.size() + certificate.text.size();
  has_answers_ = has_answers_ || answer;
  add(bytes, [g = std::move(gradation), c = std::move(certificate), a = std::move(answer)] {
    return judged(g, c, a);
  });
}

void Verdicts::check_sample(Input gradation, Input sample, Input certificate) {
  const std::size_t bytes = gradation.text.size() + sample.text.size() + certificate.text.size();
  add(bytes, [g = std::move(gradation), s = std::move(sample), c = std::move(certificate)] {
    std::string_view rest = s.text;
    return line_of(checker::check_sample(
        g, s.name, [&rest] { return std::exchange(rest, std::string_view()); }, c));
  });
}

void Verdicts::check_file(Input gradation, const std::string &certificate, SharedAnswer answer) {
  const std::size_t bytes = gradation.text.size();
  has_answers_ = has_answers_ || answer;
  add(bytes, [g = std::move(gradation), certificate, a = std::move(answer)]() -> Line {
    try {
      const Input read = read_input(certificate, most_certificate_bytes);
      if (is_sample_certificate(read.text))
        return line_of(check_sample_file(g, sample_beside(certificate), read));
      return judged(g, read, a);
    } catch (const std::runtime_error &error) {
      return {malformed_, error.what()};
    }
  });
}

void Verdicts::malformed(const std::string &reason) {
  add(reason.size(), [reason] { return Line{malformed_, reason}; });
}

void Verdicts::missing(const std::string &what) {
  add(what.size(), [what] { return Line{missing_, what}; });
}

Verdicts::Line Verdicts::judged(const Input &gradation, const Input &certificate,
                                const SharedAnswer &answer) {
  Verdict verdict = checker::check(gradation, certificate);
  if (verdict.code == Verdict::accepted && answer)
    if (const std::string what = difference(*answer, gradation.text, certificate.text); !what.empty())
      return {different, answer->place + ": not as " + printable(certificate.name) + " proves: " + what};
  return line_of(std::move(verdict));
}

Verdicts::Line Verdicts::line_of(Verdict verdict) {
  if (verdict.code == Verdict::accepted)
    return {accepted, std::move(verdict.line), std::move(verdict.question)};
  return {verdict.code == Verdict::refused ? refused : malformed_, std::move(verdict.reason)};
}

void Verdicts::add(std::size_t bytes, Job job) {
  constexpr std::size_t most_bytes = std::size_t{64} << 20U, most_a_thread = 64;
  waiting_.push_back(std::move(job));
  waiting_bytes_ += bytes;
  if (manner_.threads == 1 || waiting_.size() >= most_a_thread * manner_.threads ||
      waiting_bytes_ >= most_bytes)
    write_all();
}

void Verdicts::write_all() {
  std::vector<Line> lines(waiting_.size());
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < lines.size(); i = next++)
      lines[i] = waiting_[i]();
  };
  std::vector<std::thread> helpers;
  try {
    for (std::size_t t = 1; t < std::min<std::size_t>(manner_.threads, lines.size()); ++t)
      helpers.emplace_back(work);
  } catch (const std::system_error &) {
    // No more are to be had, as in WebAssembly: those that there are do it.
  }
  work();
  for (std::thread &helper : helpers)
    helper.join();
  waiting_.clear();
  waiting_bytes_ = 0;

  constexpr const char *words[kinds] = {"", "refused: ", "malformed: ", "missing: ", "different: "};
  std::string text;
  for (const Line &line : lines) {
    ++counts_[line.kind];
    if (line.kind == accepted)
      ++questions_[line.question];
    if (manner_.verbose || line.kind != accepted)
      text += words[line.kind] + line.text + "\n";
  }
  if (!text.empty())
    print(text);
}

/// The most frequent ones; behind them how many others there are.
std::string Verdicts::questions() const {
  constexpr std::size_t most = 12;
  std::vector<std::pair<std::string, std::uint64_t>> all(questions_.begin(), questions_.end());
  std::stable_sort(all.begin(), all.end(), [](const auto &x, const auto &y) { return x.second > y.second; });
  std::string text;
  std::uint64_t others = 0;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (i < most)
      text += "; " + std::to_string(all[i].second) + " accepted as " + all[i].first;
    else
      others += all[i].second;
  return others == 0 ? text
                     : text + "; " + std::to_string(others) + " accepted of " +
                           std::to_string(all.size() - most) + " other questions (--verbose)";
}

int Verdicts::end(const std::string &what) {
  write_all();
  if (std::all_of(std::begin(counts_), std::end(counts_), [](std::uint64_t n) { return n == 0; }))
    fail(what, "nothing to check: give the suite, and the folder or the stream of mdm batch --proofs or mdm "
               "crosscheck --proofs");
  const auto count = [this](Kind kind, const char *of) { return std::to_string(counts_[kind]) + " " + of; };
  print(printable(what) + ": " + count(accepted, "accepted, ") + count(refused, "refused, ") +
        count(malformed_, "malformed, ") + count(missing_, "missing") +
        (has_answers_ ? ", " + count(different, "different") : "") + questions() + "\n");
  return counts_[malformed_] > 0                                         ? Verdict::malformed
         : counts_[refused] + counts_[missing_] + counts_[different] > 0 ? Verdict::refused
                                                                         : Verdict::accepted;
}

} // namespace mdm::checker
