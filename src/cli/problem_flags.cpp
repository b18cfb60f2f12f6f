#include "cli/problem_flags.hpp"

#include "cli/option_tables.hpp"
#include "cli/solve_flags.hpp"
#include "crosscheck/program_text.hpp"
#include "files/file_ending.hpp"
#include "files/paths.hpp"
#include "text/option_name.hpp"

#include <mdm/text/error.hpp>

namespace mdm::cli {

void ProblemFlags::add_to(CLI::App &command) {
  command
      .add_option("--problem", language,
                  "write the integer program of the question, for other solvers: lp, mps, smt2 (z3), mzn "
                  "(MiniZinc), opb (pseudo-Boolean) or json; its optimum is a smallest match")
      ->type_name("LANGUAGE")
      ->check(CLI::IsMember(program_language_names()));
  add_asked_options(command, asked);
}

void ProblemFlags::check(const OutputFlags &output) const {
  const std::string ending = output.out ? ending_of(*output.out) : "";
  const auto refuse_ending = [&](const std::string &remedy) {
    throw InputError(shown_name(*output.out) + ": the ending ." + ending +
                     " is not that of what is written: " + remedy);
  };
  if (!language) {
    if (!asked.question_words().empty())
      throw InputError(asked.question_words() + ": it is of a question: give " + option("problem") + " too");
    if (ending != "json" && program_language_named(ending))
      refuse_ending("give " + option("problem") + " " + ending);
    return;
  }
  if (output.asked_format.value_or(*language) != *language)
    throw InputError(option("problem") + " names the form of what is written: leave out " + option("format"));
  if (ending == "csv" || (program_language_named(ending) && ending != *language))
    refuse_ending("let it be ." + *language);
}

std::string ProblemFlags::text(const Gradation &g) const {
  const ProgramLanguage asked_language = program_language_named(*language).value();
  const Question question = CrosscheckQuestion(asked, band_in_file).question(g);
  return program_text(integer_program(g, question, form_of(asked_language), *language), asked_language);
}

} // namespace mdm::cli
