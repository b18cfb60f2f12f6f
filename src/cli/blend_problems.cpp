#include "cli/blend_problems.hpp"

#include "answer/error_line.hpp"
#include "cli/exit_code.hpp"
#include "files/blend_lines.hpp"
#include "files/in_parallel.hpp"
#include "files/output.hpp"

namespace mdm::cli {
namespace {

/// A line of the output.
struct Answered {
  std::string text;
  int exit = Exit::done;
};

Answered answered(const BlendLine &line, const BlendTexts &search) {
  std::string error = line.error;
  if (line.problem)
    try {
      const BlendAnswer found = solve_blend(*line.problem, search.search());
      return {blend_json({*line.problem, found, "", {}, {}, line.id}) + "\n", exit_code(outcome_of(found))};
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
  in_order<Answered>(
      problems.size(), threads, [&](std::size_t i) { return answered(problems[i], search); },
      [&](const Answered &answer) {
        out.write(answer.text);
        worst = worse_exit(worst, answer.exit);
      });
  out.commit();
  return worst;
}

} // namespace mdm::cli
