#include "cli/verify_materials.hpp"

#include "answer/answer_sample.hpp"
#include "ask/outcome.hpp"
#include "cli/commands.hpp"
#include "cli/verification_output.hpp"
#include "files/byte_source.hpp"
#include "files/output.hpp"
#include "files/paths.hpp"
#include "files/sample_file.hpp"
#include "gradation/material_gradation.hpp"
#include "particles/material_sink.hpp"
#include "report/allowed_error.hpp"
#include "text/option_name.hpp"

#include <mdm/text/error.hpp>

namespace mdm::cli {
namespace {

std::string idle_for_verify(const MaterialRequest &r) {
  const std::pair<const char *, bool> given[] = {{"band", r.asked.band.has_value()},
                                                 {"pan-size", r.asked.gradation.pan_size.has_value()},
                                                 {"cut-below", r.asked.gradation.cut_below.has_value()},
                                                 {"packing", r.asked.places.are_asked()}};
  for (const auto &[name, is_given] : given)
    if (is_given)
      return option(name);
  return r.idle;
}

void check_question(const Question &question) {
  if (!question.law.is_power())
    throw InputError(option("law") + ": of several materials samples are judged by x^(a/b): give such a law");
}

/// The sample as the gradation describes it, with what is wrong with it.
struct DescribedSample {
  Description description;
  std::vector<std::string> objections, notes;
};

DescribedSample described_answer(const MaterialRequest &r, const Gradation &g, const VerifyQuestion &asked) {
  if (r.asked.particles.say_sizes() || r.asked.particles.timestep)
    throw file_error(r.sample, "it is an answer, which says what its sizes are: leave out " +
                                   option("radius") + ", " + option("diameter") + ", " + option("size-unit") +
                                   " and " + option("timestep"));
  const AnswerSample answer =
      read_material_answer(read_file(r.sample, max_gradation_bytes), shown_name(r.sample));
  for (const AnswerSample::Class &c : answer.classes)
    if (c.material.empty())
      throw file_error(r.sample,
                       "its classes have no materials, and the gradation has several: give the answer "
                       "of mdm solve to such a gradation");
  if (answer.has_spread)
    throw file_error(r.sample, "it is a spread, which is not judged with several materials: give the answer "
                               "without " +
                                   option("spread"));
  AnswerDescription d =
      in_file(r.sample, [&] { return describe_answer(answer, g, asked.question.law, asked.snap); });
  return {std::move(d.description), std::move(d.objections), std::move(d.notes)};
}

DescribedSample described_particles(const MaterialRequest &r, const Gradation &g,
                                    const VerifyQuestion &asked) {
  MaterialSink sink(Description(g, {asked.question.law, asked.snap, 1, 1}));
  std::vector<std::string> notes =
      read_sample_file(r.sample, asked.particles.reading(g.unit()), sink, r.output.quiet);
  return {sink.description(), {}, std::move(notes)};
}

} // namespace

int verify_materials(const MaterialRequest &r) {
  refuse_beside_materials(idle_for_verify(r), r.gradation);
  const Gradation as_read = read_material_gradation(r.content, shown_name(r.gradation));
  const VerifyQuestion asked = r.asked.question(as_read, std::nullopt);
  check_question(asked.question);
  const Gradation g = asked_gradation(as_read, asked.question);
  const AllowedError allowed =
      allowed_error(g, asked.question.tolerances, std::nullopt, asked.question.size_factor);
  const SmallestMatch smallest = in_file(r.gradation, [&] { return smallest_match(g, asked.question.law); });
  const bool is_answer =
      asked.particles.from ? *asked.particles.from == "answer" : r.sample != "-" && is_answer_file(r.sample);
  Output out(r.output.path());
  DescribedSample sample = is_answer ? described_answer(r, g, asked) : described_particles(r, g, asked);
  Verification v(std::move(sample.description), measured(asked.question), allowed.most);
  v.bounds = allowed.bounds;
  v.within = allowed.within;
  v.smallest = smallest;
  v.sample = shown_name(r.sample);
  v.digits = asked.digits;
  v.objections = std::move(sample.objections);
  v.notes = g.notes();
  v.notes.insert(v.notes.end(), sample.notes.begin(), sample.notes.end());
  write_verification(v, r.output, out);
  out.commit();
  return exit_code(outcome_of(v.verdict()));
}

} // namespace mdm::cli
