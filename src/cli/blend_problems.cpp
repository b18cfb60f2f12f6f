#include "cli/blend_problems.hpp"

#include "answer/error_line.hpp"
#include "cli/exit_code.hpp"
#include "cli/interrupted.hpp"
#include "files/blend_lines.hpp"
#include "files/in_parallel.hpp"
#include "files/interrupt.hpp"
#include "files/output.hpp"

namespace mdm::cli {
namespace {

/// A line of the output.
struct Answered {
  std::string text;
  int exit = Exit::done;
};

/// The best blend, or what is certain of it when Ctrl-C is pressed.
Answered solved(BlendProblem problem, const std::string &id, const BlendTexts &search) {
  BlendOptions options = search.search();
  options.go_on = [] { return !Interrupt::was_pressed(); };
  const BlendAnswer found = find_blends(problem, options);
  const Outcome outcome = outcome_of(found, options);
  if (outcome == Outcome::limited && Interrupt::was_pressed())
    problem.notes.push_back("the search was interrupted");
  return {blend_json({problem, found, "", {}, {}, id}) + "\n", exit_code(outcome)};
}

Answered answered(const BlendLine &line, const BlendTexts &search) {
  std::string error = line.error;
  if (line.problem)
    try {
      return solved(*line.problem, line.id, search);
    } catch (const InputError &e) {
      error = e.what();
    }
  return {error_line(line.id, line.where + ": " + error), Exit::bad_input};
}

} // namespace

int blend_problems(const std::string &path, const BlendTexts &search, unsigned threads,
                   const OutputFlags &output) {
  static_cast<void>(search.search()); // what is wrong is said before a file is read
  FileLines lines(path);
  const std::vector<BlendLine> problems = read_blend_lines(lines, path);
  Output out(output.path());
  int worst = Exit::done;
  const Interrupt interrupt;
  const std::size_t done = in_order<Answered>(
      problems.size(), threads, [&](std::size_t i) { return answered(problems[i], search); },
      [&](const Answered &answer) {
        out.write(answer.text);
        worst = worse_exit(worst, answer.exit);
      },
      Interrupt::was_pressed);
  out.commit();
  if (done == problems.size())
    return worst;
  output.tell_notes({interrupted_after(done, "problem")});
  return worse_exit(worst, Exit::limited);
}

} // namespace mdm::cli
