#include "cli/solve_number.hpp"

#include "answer/number_answer.hpp"
#include "files/output.hpp"
#include "files/paths.hpp"
#include "files/standard_streams.hpp"
#include "gradation/number_gradation.hpp"
#include "proof/number_certificate.hpp"
#include "text/file_names.hpp"
#include "text/option_name.hpp"

#include <mdm/text/error.hpp>

#include <memory>

namespace mdm::cli {
namespace {

/// The first option of solving that is given and has no use here; empty: none.
std::string idle_option(const SolveFlags &flags) {
  std::string idle = flags.band ? option("band") : "";
  for_each_option(flags, [&](const char *name, const OptionText &text) {
    if (text && idle.empty())
      idle = option(name);
  });
  return idle;
}

} // namespace

void refuse_beside_numbers(const std::string &given, const std::string &file) {
  throw InputError(given + ": it is of gradations by mass, and " + printable(file) +
                   " has shares by number: leave it out");
}

Exit solve_number(const NumberRequest &r) {
  const std::string idle = r.idle.empty() ? idle_option(r.flags) : r.idle;
  if (!idle.empty())
    refuse_beside_numbers(idle, r.file);
  std::vector<AskedTolerance> asked;
  for (const std::string &text : r.flags.tolerances)
    asked.push_back(parse_tolerance(text));
  Gradation g = read_number_gradation(r.content, shown_name(r.file));
  Output out(r.output.path());
  NumberMatch match = in_file(r.file, [&] { return number_match(g, asked); });
  std::vector<std::string> notes = g.notes();
  const NumberAnswer answer{std::move(g), std::move(asked), std::move(match), std::move(notes)};
  std::unique_ptr<Output> proof;
  if (r.proof) {
    proof = std::make_unique<Output>(*r.proof);
    proof->write(number_certificate(answer.match, answer.asked));
  }
  out.write(r.output.report([&] { return number_text(answer); }, [&] { return number_json(answer); },
                            [&] { return number_csv(answer); }));
  if (r.output.is_csv() && !answer.match.is_smallest())
    tell(printable(answer.gradation.id()) + ": " + headline(answer) + "\n");
  r.output.tell_notes_beside_csv(answer.notes);
  if (proof)
    proof->commit();
  out.commit();
  return answer.match.is_smallest() ? Exit::done : Exit::limited;
}

} // namespace mdm::cli
