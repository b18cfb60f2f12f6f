#include "cli/export_particles.hpp"

#include "answer/answer.hpp"
#include "answer/answer_particles.hpp"
#include "answer/answer_sample.hpp"
#include "ask/option_values.hpp"
#include "cli/progress.hpp"
#include "cli/sample_file.hpp"
#include "files/byte_source.hpp"
#include "files/paths.hpp"
#include "files/standard_streams.hpp"
#include "particles/sample_set.hpp"
#include "text/json_member.hpp"
#include "text/lines.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

namespace mdm::cli {
namespace {

/// True if a model takes the option, too: the specimen's shape and void ratio.
bool is_of_model(const ExportCommand &c, const std::string &option) {
  return c.model && (option == "--specimen" || option == "--void-ratio");
}

/// A specimen sets the number of particles where its void ratio is known; a model takes either alone.
SolveFlags flags_of_solving(const ExportCommand &c) {
  SolveFlags flags = c.flags;
  if (c.model && !(flags.specimen && flags.void_ratio))
    flags.specimen = flags.void_ratio = std::nullopt;
  return flags;
}

/// Refuses the options of solving, of which there is no more to ask. \param what  the particles
void refuse_options_of_solving(const ExportCommand &c, const char *what) {
  for (const CLI::Option *option : c.solving)
    if (option->count() > 0 && option->get_name() != "--law" && !is_of_model(c, option->get_name()))
      throw InputError(fmt::format("{}: {} in {} is solved already: leave it out, or export the gradation",
                                   option->get_name(), what, printable(shown_name(*c.file))));
}

ExportedParticles answer_particles(const ExportCommand &c, const std::string &content,
                                   const ParticleSetOptions &options) {
  refuse_options_of_solving(c, "the answer");
  const AnswerSample answer = read_answer(content, shown_name(*c.file));
  const MassLaw law = c.flags.GradationTexts::question().rest.law;
  c.output.tell_notes(answer.notes);
  return {in_file(*c.file, [&] { return particle_set(answer, law, options); }), Exit::done, answer.unit,
          answer.question, false};
}

/// The particles of a file of them, as they are.
ExportedParticles sample_particles(const ExportCommand &c, const ParticleSetOptions &options) {
  refuse_options_of_solving(c, "the set of particles");
  if (c.spread || c.reading.is_given())
    throw InputError((c.spread ? "--spread" : c.reading.given()) + ": " + printable(*c.file) +
                     " holds particles already: leave it out");
  ParticleOptions reading;
  reading.says_otherwise = "--size-unit says";
  if (c.size_unit)
    reading.unit = length_unit_of("size-unit", *c.size_unit);
  SampleSet sample;
  c.output.tell_notes(read_sample_file(*c.file, reading, sample, c.output.quiet));
  return {in_file(*c.file, [&] { return sample.set(stem(*c.file), LengthUnit::mm, options); }), Exit::done,
          SizeUnit::mm, "", false};
}

/// \param content of FILE; open: there is the band alone
ExportedParticles solved_particles(const ExportCommand &c, const std::optional<std::string> &content,
                                   const ParticleSetOptions &options) {
  const AskedQuestion asked = flags_of_solving(c).question();
  Progress progress([] { return std::string("solving"); }, c.output.quiet);
  const std::string &source = c.flags.source(c.file);
  const Gradation g = content ? read_gradation(*content, shown_name(source), c.reading.reading())
                              : in_file(source, [&] { return middle_of(*asked.rest.band); });
  const Question question = asked.in(g.unit());
  const SolveOptions solve_options = c.flags.options();
  const Match m = in_file(source, [&] { return solve(g, question, solve_options); });
  c.output.tell_notes(m.gradation.notes()); // solve's own are of doubles that may leave their class
  if (m.status != Status::optimal)
    tell(printable(m.gradation.id()) + ": " + headline(m) + "\n");
  const int code = exit_code(outcome_of(m, solve_options.limits));
  if (!m.has_answer())
    return {std::nullopt, code, m.gradation.unit(), ""};
  const std::uint64_t seed = seed_of(c);
  return {
      in_file(source,
              [&] { return c.spread ? spread_particle_set(m, seed, options) : particle_set(m, options); }),
      code, m.gradation.unit(), ""};
}

} // namespace

ParticleSetOptions set_options(const ExportCommand &c, bool has_floats) {
  ParticleSetOptions options;
  if (c.unit)
    options.unit = length_unit_of("unit", *c.unit);
  if (c.density)
    options.density = physical("density", *c.density);
  options.has_floats = has_floats;
  if (has_floats)
    options.most_mass_error = ratio(1, 5000000); // of a cube: three times that of a float
  if (c.mass_error)
    options.most_mass_error = positive("mass-error", *c.mass_error);
  return options;
}

ExportedParticles exported_particles(const ExportCommand &c, const ParticleSetOptions &options) {
  if (c.file && is_sample_file(*c.file))
    return sample_particles(c, options);
  if (c.size_unit)
    throw InputError("--size-unit: it is of files of particles, and FILE is none: leave it out");
  std::optional<std::string> content;
  if (c.file)
    content = read_file(*c.file, max_gradation_bytes);
  if (content && is_sample(*content))
    throw file_error(*c.file, "it holds particles: give them as a file, by its name");
  return content && json_schema(*content) ? answer_particles(c, *content, options)
                                          : solved_particles(c, content, options);
}

std::optional<std::string> verify_options(const ExportCommand &c) {
  if (!c.file)
    return std::nullopt;
  std::string options;
  const auto add = [&options](const char *option, const OptionText &value) {
    if (value)
      options += std::string(" ") + option + " " + *value;
  };
  add("--law", c.flags.law);
  add("--size-factor", c.flags.size_factor);
  add("--cut-below", c.flags.cut_below);
  add("--pan-size", c.flags.pan_size);
  return options + c.reading.words();
}

} // namespace mdm::cli
