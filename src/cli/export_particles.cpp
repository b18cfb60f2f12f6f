#include "cli/export_particles.hpp"

#include "answer/answer.hpp"
#include "answer/answer_particles.hpp"
#include "answer/answer_sample.hpp"
#include "ask/asked_search.hpp"
#include "ask/option_values.hpp"
#include "cli/export_command.hpp"
#include "cli/searched.hpp"
#include "files/byte_source.hpp"
#include "files/interrupt.hpp"
#include "files/paths.hpp"
#include "files/sample_file.hpp"
#include "files/standard_streams.hpp"
#include "gradation/material_gradation.hpp"
#include "particles/sample_set.hpp"
#include "text/json_member.hpp"
#include "text/lines.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

namespace mdm::cli {
namespace {

ExportedParticles answer_particles(const ExportTexts &c, const OutputFlags &output,
                                   const std::string &content, const ParticleSetOptions &options) {
  refuse_options_of_solving(c, "the answer");
  const AnswerSample answer = read_answer(content, shown_name(*c.file));
  const MassLaw law = c.solve.GradationTexts::question().law_in(answer.unit);
  output.tell_notes(answer.notes);
  return {in_file(*c.file, [&] { return particle_set(answer, law, options); }), Outcome::done, answer.unit,
          answer.question, false};
}

/// The particles of a file of them, as they are.
ExportedParticles sample_particles(const ExportTexts &c, const OutputFlags &output,
                                   const ParticleSetOptions &options) {
  refuse_options_of_solving(c, "the set of particles");
  if (c.spread || c.reading.is_given())
    throw InputError((c.spread ? option("spread") : c.reading.given()) + ": " + printable(*c.file) +
                     " holds particles already: leave it out");
  SampleSet sample;
  output.tell_notes(read_sample_file(*c.file, c.particles.reading(SizeUnit::mm), sample, output.quiet));
  if (!c.gradation && sample.has_classes())
    output.tell_notes({"the classes are those that the particles in FILE say, by type or class"});
  if (!c.gradation && sample.has_other_classes())
    output.tell_notes({"the types of the particles in FILE have sizes in common: classes are by size, up to "
                       "1.41 times the smallest"});
  std::optional<Gradation> sieves;
  if (c.gradation)
    sieves = any_gradation(*c.gradation, ReadingFlags{}, output.quiet).gradation;
  else if (is_generated_file(*c.file)) // it has its classes
    sieves = any_gradation(*c.file, ReadingFlags{}, output.quiet).gradation;
  ExportedParticles found{
      in_file(*c.file,
              [&] { return sample.set(stem(*c.file), SizeUnit::mm, options, sieves ? &*sieves : nullptr); }),
      Outcome::done, SizeUnit::mm, "", false};
  if (!c.start || c.start == "as-is")
    found.places = in_file(*c.file, [&] { return sample.places(*found.set, SizeUnit::mm); });
  return found;
}

/// Says how the particles match: all of it, or what an exported file does not show.
void tell_answer(const Match &m, const OutputFlags &output) {
  const std::string id = printable(m.gradation.id()) + ": ";
  if (output.verbose && !output.quiet)
    return tell(answer_text(m, nullptr, nullptr, true));
  output.tell_notes(m.gradation.notes()); // solve's own are of doubles that may leave their class
  if (is_open(m) && Interrupt::was_pressed())
    output.tell_notes({"the search was interrupted"});
  if (m.status != Status::optimal)
    tell(id + headline(m) + "\n");
  if (m.budget && !output.quiet)
    tell(id + budget_text(*m.budget) + "\n");
}

/// An option that has no use for a gradation of several materials; empty: none.
std::string idle_for_materials(const ExportTexts &c) {
  if (const std::string idle = c.solve.idle_for_materials(c.budget); !idle.empty())
    return idle;
  return c.spread ? option("spread") : c.gradation ? option("gradation") : c.reading.given();
}

/// The gradation in FILE. A unit that the file does not say is none of export's options.
Gradation read_to_export(const ExportTexts &c, const std::string &content) {
  try {
    return read_gradation(content, shown_name(*c.file), c.reading.reading());
  } catch (const InputError &e) {
    const std::string message = e.what();
    if (message.find(option("unit")) == std::string::npos)
      throw;
    throw InputError(message + "; mdm convert takes it: here it is of the file that is written");
  }
}

/// \param content of FILE; open: there is the band alone
ExportedParticles solved_particles(const ExportTexts &c, const OutputFlags &output,
                                   const std::optional<std::string> &content,
                                   const ParticleSetOptions &options) {
  const AskedSearch search(texts_of_solving(c), c.budget, band_in_file, false);
  const std::string &source = c.solve.source(c.file);
  const auto read = [&] {
    if (!content)
      return in_file(source, [&] { return middle_of(*search.question().rest.band); });
    if (!is_material_gradation(*content))
      return read_to_export(c, *content);
    refuse_beside_materials(idle_for_materials(c), source);
    Gradation of = read_material_gradation(*content, shown_name(source));
    if (of.has_factors() && !c.density)
      throw file_error(source, "its factors are multiplied by " + option("density") +
                                   ": give it, 1000 where they are densities in g/cm^3");
    return of;
  };
  const Gradation g = read();
  const Found found =
      in_file(source, [&] { return searched(search, g, search.question().of(g), output.quiet); });
  const Match &m = found.match;
  tell_answer(m, output);
  if (!m.has_answer())
    return {std::nullopt, found.outcome, m.gradation.unit(), ""};
  const std::uint64_t seed = export_seed(c);
  ExportedParticles particles{
      in_file(source,
              [&] { return c.spread ? spread_particle_set(m, seed, options) : particle_set(m, options); }),
      found.outcome, m.gradation.unit(), ""};
  if (m.budget && m.budget->by == BudgetBy::size_factor)
    particles.size_factor = to_decimal(*m.budget->enough);
  return particles;
}

} // namespace

ExportedParticles exported_particles(const ExportTexts &c, const OutputFlags &output,
                                     const ParticleSetOptions &options) {
  if (c.file && (c.particles.size_column || is_sample_file(*c.file)))
    return sample_particles(c, output, options);
  if (c.gradation)
    throw InputError(option("gradation") + ": it is of files of particles, and FILE is none: leave it out");
  if (c.particles.say_sizes() || c.particles.timestep)
    throw InputError(option(c.particles.timestep    ? "timestep"
                            : c.particles.size_unit ? "size-unit"
                            : c.particles.radius    ? "radius"
                                                    : "diameter") +
                     ": it is of files of particles, and FILE is none: leave it out");
  std::optional<std::string> content;
  if (c.file)
    content = read_file(*c.file, max_gradation_bytes);
  if (content && is_sample(*content))
    throw file_error(*c.file, "it holds particles: give them as a file, by its name");
  return content && json_schema(*content) ? answer_particles(c, output, *content, options)
                                          : solved_particles(c, output, content, options);
}

} // namespace mdm::cli
