#include "cli/solve_flags.hpp"

#include "cli/help.hpp"
#include "cli/option_tables.hpp"
#include "files/byte_source.hpp"
#include "files/paths.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/text/error.hpp>

namespace mdm::cli {

namespace {

void add_question_options(CLI::App &command, SolveTexts &texts,
                          const std::vector<OptionRow<SolveTexts>> &further = {}) {
  const OptionGroup group(command, "The question");
  for (const auto *const rows : {&SolveTexts::tolerance_options, &SolveTexts::question_options, &further})
    add_options(command, *rows, texts);
}

} // namespace

Envelope band_in_file(const std::string &path) {
  return read_envelope(read_file(path, max_gradation_bytes), shown_name(path));
}

void add_gradation_options(CLI::App &command, GradationTexts &texts) {
  const OptionGroup group(command, "The gradation");
  add_options(command, GradationTexts::options, texts);
}

void add_asked_options(CLI::App &command, SolveTexts &texts) {
  add_question_options(command, texts);
  add_gradation_options(command, texts);
}

void SolveFlags::add_problem(CLI::App &command) {
  add_question_options(command, *this, search_options);
  add_gradation_options(command, *this);
  add_limits(command);
}

void SolveFlags::add_to(CLI::App &command) {
  add_problem(command);
  const OptionGroup group(command, "The answer");
  add_options(command, answer_options, *this);
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
