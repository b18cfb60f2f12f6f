#include "cli/solve_flags.hpp"

#include "cli/help.hpp"
#include "cli/option_tables.hpp"
#include "files/byte_source.hpp"
#include "files/paths.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/text/error.hpp>

namespace mdm::cli {

Envelope band_in_file(const std::string &path) {
  return read_envelope(read_file(path, max_gradation_bytes), shown_name(path));
}

void add_gradation_options(CLI::App &command, GradationTexts &texts) {
  const OptionGroup group(command, "The gradation");
  add_options(command, GradationTexts::options, texts);
}

void SolveFlags::add_asked(CLI::App &command) {
  add_question(command);
  add_gradation_options(command, *this);
}

void SolveFlags::add_problem(CLI::App &command) {
  add_asked(command);
  add_limits(command);
}

void SolveFlags::add_to(CLI::App &command) {
  add_problem(command);
  const OptionGroup group(command, "The answer");
  add_options(command, answer_options, *this);
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
                  "passing_max_percent of each sieve, or a table with columns such as Lower and Upper")
      ->type_name("FILE");
  add_options(command, question_options, *this);
}

void SolveFlags::add_limits(CLI::App &command) {
  const OptionGroup group(command, "Limits");
  add_options(command, limit_options, *this);
}

AskedQuestion SolveFlags::question() const {
  return SolveTexts::question(band_in_file);
}

AskedQuestion SolveFlags::question_of_both() const {
  return SolveTexts::question_of_both(band_in_file);
}

void SolveFlags::check_source(const OptionText &file, const std::string &reading,
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
  const auto add = [&text](const char *name, const OptionText &value) {
    if (value)
      text += std::string(text.empty() ? "--" : " --") + name + " " + *value;
  };
  for (const std::string &tolerance : tolerances)
    add("tolerance", tolerance);
  if (band) {
    Digest digest;
    digest.add(read_file(*band, max_gradation_bytes));
    add("band", "sha256:" + digest.sha256());
  }
  for_each_option(*this, [&add](const char *name, const OptionText &value) { add(name, value); });
  return text;
}

} // namespace mdm::cli
