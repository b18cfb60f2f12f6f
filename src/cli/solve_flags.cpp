#include "cli/solve_flags.hpp"

#include "cli/files.hpp"
#include "cli/help.hpp"
#include "cli/option_values.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/text/error.hpp>

namespace mdm::cli {
namespace {

ScaleChoice scale_of(const std::string &text) {
  if (text == "robust")
    return ScaleChoice::robust;
  if (text == "upper")
    return ScaleChoice::upper;
  throw InputError("--scale: " + in_quotes(text) + " is neither robust nor upper");
}

} // namespace

void GradationFlags::add_to(CLI::App &command) {
  const OptionGroup group(command, "The gradation");
  command.add_option("--law", law, "mass of a particle of size x: sphere (x^3), power:a/b or power:2.5")
      ->type_name("LAW");
  command.add_option("--size-factor", size_factor, "multiply every size of the gradation by K")
      ->type_name("K");
  command
      .add_option("--cut-below", cut_below,
                  "leave out the classes below the sieve SIZE, as 63um or in the file's unit (before "
                  "--size-factor)")
      ->type_name("SIZE");
  command
      .add_option("--pan-size", pan_size,
                  "count the pan as SIZE, as 2um or in the file's unit, instead of 0 (before "
                  "--size-factor)")
      ->type_name("SIZE");
}

AskedQuestion GradationFlags::question() const {
  AskedQuestion asked;
  if (law)
    asked.rest.law = named("--law", *law, parse_mass_law);
  if (pan_size)
    asked.pan_size = length("--pan-size", *pan_size);
  if (cut_below)
    asked.cut_below = length("--cut-below", *cut_below);
  if (size_factor)
    asked.rest.size_factor = positive("--size-factor", *size_factor);
  return asked;
}

void SolveFlags::add_problem(CLI::App &command) {
  add_question(command);
  GradationFlags::add_to(command);
  add_limits(command);
}

void SolveFlags::add_to(CLI::App &command) {
  add_problem(command);
  const OptionGroup group(command, "The answer");
  command.add_option("--digits", digits, "significant digits of sizes (15)")->type_name("D");
  command.add_option("--scale", scale, "robust (sizes far from the sieves) or upper (largest sizes)")
      ->type_name("WHICH");
}

void SolveFlags::add_question(CLI::App &command) {
  const OptionGroup group(command, "The question");
  command
      .add_option(
          "--tolerance", tolerances,
          "the smallest match within a tolerance: retained:1%, passing:0.5%, total:1% (percentage points), "
          "retained:file, passing:file (column tolerance_percent), laboratory, rounding; may be repeated")
      ->type_name("WHICH")
      ->allow_extra_args(false);
  command
      .add_option("--band", band,
                  "the smallest match within the envelope in FILE: CSV with passing_min_percent and "
                  "passing_max_percent of each sieve")
      ->type_name("FILE");
  command.add_option("--min-per-class", min_per_class, "at least R particles in every class with mass")
      ->type_name("R");
  command.add_option("--at-least", at_least, "the smallest match with at least N particles")->type_name("N");
  command.add_option("--at-most", at_most, "no match if the smallest has more than N particles")
      ->type_name("N");
  command
      .add_option(
          "--specimen", specimen,
          "at least the solids of a specimen: cylinder:DxH or box:AxBxC; lengths as 50mm, 63um, 2m, 0.5in, "
          "or in the answer's unit (the file's; mm for inches, phi and sieve names)")
      ->type_name("SHAPE");
  command.add_option("--void-ratio", void_ratio, "void ratio e of the specimen")->type_name("E");
  command
      .add_option("--solids-volume", solids_volume,
                  "at least this volume of solids, in the cube of the answer's unit")
      ->type_name("V");
}

void SolveFlags::add_limits(CLI::App &command) {
  const OptionGroup group(command, "Limits");
  command
      .add_option("--max-steps", max_steps,
                  "stop after so many steps (67108864), with what is certain (exit 3)")
      ->type_name("N");
  command
      .add_option("--node-limit", node_limit,
                  "stop after so many nodes of the search for a tolerance (exit 3)")
      ->type_name("N");
  command.add_option("--time-limit", time_limit, "stop after so many seconds (exit 3)")->type_name("S");
  command
      .add_option("--gap", gap,
                  "within a tolerance, stop at a match that has at most this part of its particles more than "
                  "are certain, for example 1e-6 (exit 0)")
      ->type_name("G");
}

AskedQuestion SolveFlags::question() const {
  if (is_tolerant() && scale)
    throw InputError("--scale: sizes within a tolerance are as far from all bounds as can be: leave it out");
  if (is_tolerant() && max_steps)
    throw InputError("--max-steps: it is of exact matches: give --node-limit, or --time-limit");
  if (!is_tolerant() && node_limit)
    throw InputError("--node-limit: it is of matches within a tolerance: give --max-steps, or --time-limit");
  if (!is_tolerant() && gap)
    throw InputError("--gap: it is of matches within a tolerance: give --max-steps, or --time-limit");
  return question_of_both();
}

AskedQuestion SolveFlags::question_of_both() const {
  AskedQuestion asked = GradationFlags::question();
  Question &q = asked.rest;
  for (const std::string &text : tolerances)
    q.tolerances.push_back(named("--tolerance", text, parse_tolerance));
  if (band)
    q.band = read_envelope(read_file(*band, max_gradation_bytes), shown_name(*band));
  if (min_per_class)
    q.min_per_class = natural("--min-per-class", *min_per_class, 0);
  if (at_least)
    q.at_least = std::max(natural("--at-least", *at_least, 0), Integer(1));
  if (specimen.has_value() != void_ratio.has_value())
    throw InputError("--specimen and --void-ratio belong together");
  if (specimen && solids_volume)
    throw InputError("--specimen and --solids-volume: give one of them");
  if (void_ratio)
    not_negative("--void-ratio", *void_ratio);
  if (solids_volume)
    q.solids = SolidsVolume{positive("--solids-volume", *solids_volume)};
  if (specimen)
    asked.specimen = AskedSpecimen{*specimen, *void_ratio};
  asked.in(SizeUnit::mm); // refuses a wrong specimen before a file is read
  return asked;
}

void SolveFlags::check_source(const Text &file, const std::string &reading,
                              const std::string &command) const {
  if (!file && !band)
    throw InputError("mdm: FILE is required, or --band; see mdm " + command + " --help");
  if (!file && !reading.empty())
    throw InputError(reading + ": it is of the gradation's FILE, and there is none: leave it out");
  if (file == "-" && band == "-")
    throw InputError("--band: standard input is the gradation already: give one of them by name");
}

SolveOptions SolveFlags::options(bool keep_proof) const {
  SolveOptions o;
  o.limits.keep_proof = keep_proof;
  if (at_most)
    o.at_most = natural("--at-most", *at_most, 0);
  if (digits)
    o.digits = digits_of("--digits", *digits);
  if (scale)
    o.scale = scale_of(*scale);
  if (max_steps)
    o.limits.max_steps = natural64("--max-steps", *max_steps);
  if (node_limit)
    o.limits.node_limit = natural64("--node-limit", *node_limit);
  if (gap)
    o.limits.gap = not_negative("--gap", *gap);
  if (time_limit)
    o.limits.deadline = std::chrono::steady_clock::now() + duration("--time-limit", *time_limit);
  return o;
}

} // namespace mdm::cli
