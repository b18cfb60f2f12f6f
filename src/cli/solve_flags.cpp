#include "cli/solve_flags.hpp"

#include "cli/help.hpp"
#include "cli/option_tables.hpp"
#include "files/byte_source.hpp"
#include "files/paths.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/text/error.hpp>

#include <map>

namespace mdm::cli {

namespace {

void add_question_options(CLI::App &command, SolveTexts &texts,
                          const std::vector<OptionRow<SolveTexts>> &further = {}) {
  const OptionGroup group(command, "The question");
  for (const auto *const rows :
       {&SolveTexts::tolerance_options, &SolveTexts::band_options, &SolveTexts::question_options, &further})
    add_options(command, *rows, texts);
}

void add_gradation_rows(CLI::App &command, const std::vector<OptionRow<GradationTexts>> &rows,
                        GradationTexts &texts) {
  add_options(command, rows, texts);
  command.get_option("--law")->each([](const std::string &law) {
    if (law.starts_with(law_by_table))
      protect_input(law.substr(law_by_table.size()));
  });
}

} // namespace

std::string law_in_file(const std::string &path) {
  static std::map<std::string, std::string>
      read; // a law is asked for more than once, and a pipe is read once
  const auto [at, is_new] = read.try_emplace(path);
  if (is_new)
    at->second = read_file(path, max_gradation_bytes);
  return at->second;
}

Envelope band_in_file(const std::string &path) {
  return read_envelope(read_file(path, max_gradation_bytes), shown_name(path));
}

void add_gradation_options(CLI::App &command, GradationTexts &texts) {
  const OptionGroup group(command, "The gradation");
  add_gradation_rows(command, GradationTexts::options, texts);
}

void add_match_options(CLI::App &command, SolveTexts &texts, BudgetTexts &budget) {
  const OptionGroup group(command, "The match");
  add_options(command, SolveTexts::tolerance_options, texts);
  add_options(command, BudgetTexts::options, budget);
  std::vector<OptionRow<GradationTexts>> of_gradation = GradationTexts::options;
  std::erase_if(of_gradation, [](const OptionRow<GradationTexts> &row) {
    return row.name == std::string_view("pan-size");
  });
  add_gradation_rows(command, of_gradation, texts);
  for (const auto *const rows : {&SolveTexts::question_options, &SolveTexts::search_options,
                                 &SolveTexts::answer_options, &SolveTexts::limit_options})
    add_options(command, *rows, texts);
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
  {
    const OptionGroup group(command, "The question");
    add_options(command, BudgetTexts::options, budget);
  }
  const OptionGroup group(command, "The answer");
  add_options(command, answer_options, *this);
}

void SolveFlags::add_limits(CLI::App &command) {
  const OptionGroup group(command, "Limits");
  add_options(command, limit_options, *this);
}

std::string SolveFlags::words() const {
  std::string text;
  const auto add = [&text](const char *name, const OptionText &value) {
    if (value)
      text += std::string(text.empty() ? "--" : " --") + name + " " + *value;
  };
  for (const std::string &tolerance : tolerances)
    add("tolerance", tolerance);
  const auto digest_of = [](const std::string &content) {
    Digest digest;
    digest.add(content);
    return "sha256:" + digest.sha256();
  };
  if (band)
    add("band", digest_of(read_file(*band, max_gradation_bytes)));
  for_each_option(*this, [&](const char *name, const OptionText &value) {
    const bool is_table = value && std::string_view(name) == "law" && value->starts_with(law_by_table);
    add(name, is_table ? OptionText(std::string(law_by_table) +
                                    digest_of(law_in_file(value->substr(law_by_table.size()))))
                       : value);
  });
  for (const OptionRow<BudgetTexts> &row : BudgetTexts::options)
    add(row.name, budget.*row.text());
  return text;
}

} // namespace mdm::cli
