#include "cli/solve_flags.hpp"

#include "cli/files.hpp"
#include "cli/help.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/text/error.hpp>

namespace mdm::cli {
namespace {

void add_gradation(CLI::App &command, GradationTexts &texts) {
  const OptionGroup group(command, "The gradation");
  command
      .add_option("--law", texts.law, "mass of a particle of size x: sphere (x^3), power:a/b or power:2.5")
      ->type_name("LAW");
  command.add_option("--size-factor", texts.size_factor, "multiply every size of the gradation by K")
      ->type_name("K");
  command
      .add_option("--cut-below", texts.cut_below,
                  "leave out the classes below the sieve SIZE, as 63um or in the file's unit (before "
                  "--size-factor)")
      ->type_name("SIZE");
  command
      .add_option("--pan-size", texts.pan_size,
                  "count the pan as SIZE, as 2um or in the file's unit, instead of 0 (before "
                  "--size-factor)")
      ->type_name("SIZE");
}

} // namespace

Envelope band_in_file(const std::string &path) {
  return read_envelope(read_file(path, max_gradation_bytes), shown_name(path));
}

void GradationFlags::add_to(CLI::App &command) {
  add_gradation(command, *this);
}

void SolveFlags::add_problem(CLI::App &command) {
  add_question(command);
  add_gradation(command, *this);
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
  return SolveTexts::question(band_in_file);
}

AskedQuestion SolveFlags::question_of_both() const {
  return SolveTexts::question_of_both(band_in_file);
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

std::string SolveFlags::words() const {
  std::string text;
  const auto add = [&text](const char *option, const Text &value) {
    if (value)
      text += std::string(text.empty() ? "" : " ") + option + " " + *value;
  };
  for (const std::string &tolerance : tolerances)
    add("--tolerance", tolerance);
  if (band) {
    Digest digest;
    digest.add(read_file(*band, max_gradation_bytes));
    add("--band", "sha256:" + digest.sha256());
  }
  for (const auto &[option, value] : all)
    add(option, this->*value);
  return text;
}

} // namespace mdm::cli
