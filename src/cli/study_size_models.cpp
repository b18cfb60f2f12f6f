#include "cli/study_size_models.hpp"

#include "ask/option_values.hpp"
#include "cli/exit_code.hpp"
#include "cli/study_packings.hpp"
#include "cli/whole_number.hpp"
#include "files/in_parallel.hpp"
#include "files/progress_line.hpp"
#include "papers/model_statements.hpp"
#include "papers/packing_statements.hpp"
#include "papers/size_model_figures.hpp"
#include "papers/size_model_tables.hpp"

#include <fmt/core.h>

#include <atomic>
#include <iterator>
#include <thread>

namespace mdm::cli {
namespace {

PackingStudyOptions packing_options(const SizeModelFlags &flags, bool quiet) {
  constexpr std::uint64_t most_seeds = 1000;
  PackingStudyOptions o;
  if (flags.at_least)
    o.terms.at_least = natural("at-least", *flags.at_least, 1);
  if (flags.at_most)
    o.terms.at_most = natural("at-most", *flags.at_most, 1);
  if (o.terms.at_most > Integer(most_discs))
    throw InputError(option("at-most") + ": a packing has up to 10^7 discs: give fewer");
  if (flags.seeds)
    o.seeds = natural64("seeds", *flags.seeds);
  if (o.seeds < 1 || o.seeds > most_seeds)
    throw InputError(option("seeds") + ": " + in_quotes(*flags.seeds) +
                     " is not a whole number from 1 to 1000");
  o.spans = flags.spans ? number_list("spans", *flags.spans) : packed_spans();
  for (const Rational &span : o.spans)
    if (span >= 1)
      throw InputError(option("spans") + ": a span is between 0 and 1: write for example 0.1,0.4,0.9");
  o.threads = flags.threads.value_or(std::max(1U, std::thread::hardware_concurrency()));
  o.quiet = quiet;
  return o;
}

/// Answers in the order of the questions, found by several threads.
class Answers {
public:
  Answers(unsigned threads, bool quiet)
      : threads_(threads),
        progress_([this] { return fmt::format("{} curves and sets", count_.load()); }, quiet) {}

  template <class Question, class Answer>
  auto operator()(const std::vector<Question> &questions, Answer answer) {
    std::vector<std::optional<decltype(answer(questions.front()))>> found(questions.size());
    in_parallel(questions.size(), threads_, [&](std::size_t i) {
      found[i] = answer(questions[i]);
      ++count_;
    });
    std::vector<decltype(answer(questions.front()))> all;
    for (auto &one : found)
      all.push_back(std::move(*one));
    return all;
  }

private:
  unsigned threads_;
  std::atomic<std::uint64_t> count_ = 0;
  ProgressLine progress_;
};

/// Figures 1 and 3 to 8; the statements on them are added to those that there are.
std::vector<StudyFile> model_files(Answers &answers, const std::optional<StudyPictures> &pictures,
                                   std::vector<Statement> &statements) {
  static const Integer most_drawn = 50000;
  const auto sets = [&answers](const std::vector<SetQuestion> &questions) {
    return answers(questions, [](const SetQuestion &q) { return set_row(q, most_drawn); });
  };
  const std::vector<DistributionRow> densities = figure1_rows();
  const std::vector<PassingRow> curves = figure3_rows();
  const ModelStudy study{figure4_rows(), sets(figure5_questions()), sets(figure6_questions()),
                         sets(figure7_questions()), answers(figure8_maps(), shape_row)};
  const std::vector<ShapeRow> spans = answers(figure8_spans(), shape_row);
  std::vector<Statement> more = model_statements(study);
  std::move(more.begin(), more.end(), std::back_inserter(statements));
  std::vector<StudyFile> files = {
      {"figure1.csv", table_csv(densities)},          {"figure3.csv", table_csv(curves)},
      {"figure4.csv", table_csv(study.coefficients)}, {"figure5.csv", table_csv(study.classes)},
      {"figure6.csv", table_csv(study.class_sizes)},  {"figure7.csv", table_csv(study.totals)},
      {"figure8.csv", table_csv(study.maps)},         {"figure8-spans.csv", table_csv(spans)}};
  if (pictures) {
    files.push_back(pictures->drawn("figure1", distribution_figure(densities)));
    files.push_back(pictures->drawn("figure3", passing_figure(curves)));
    files.push_back(pictures->drawn("figure4", coefficient_figure(study.coefficients)));
    files.push_back(pictures->drawn("figure5", set_figure(study.classes, Criterion::classes)));
    files.push_back(pictures->drawn("figure6", set_figure(study.class_sizes, Criterion::min_per_class)));
    files.push_back(pictures->drawn("figure7", set_figure(study.totals, Criterion::at_least)));
    files.push_back(pictures->drawn("figure8", accessible_figure(study.maps, spans)));
  }
  return files;
}

} // namespace

void SizeModelFlags::add_to(CLI::App &command) {
  const auto option = [&command](const char *name, auto &value, const char *type, const char *help) {
    return command.add_option(name, value, help)->type_name(type);
  };
  option("--only", only, "TEXT",
         "voivret: models, the figures of size distributions alone (1, 3 to 8), or packings (2, 9 to 11)")
      ->check(CLI::IsMember({"models", "packings"}));
  option("--at-least", at_least, "N", "voivret: discs of a deposit of Figure 9 (25000)");
  option("--at-most", at_most, "N", "voivret: points that take more discs are left out (100000)");
  option("--seeds", seeds, "K", "voivret: deposits of a point, with the seeds 1 to K (4)");
  option("--spans", spans, "LIST",
         "voivret: spans of Figure 9, numbers 0.1,0.4 or FROM:TO:STEP (0.02, 0.05, 0.1 to 0.9, 0.97)");
  option("-j", threads, "THREADS", "voivret: threads (as many as there are processors)")
      ->transform(whole_number(1, 1024));
}

int run_size_models(const SizeModelFlags &flags, const std::string &folder,
                    const std::optional<std::string> &plots, bool quiet) {
  const PackingStudyOptions options = packing_options(flags, quiet);
  std::optional<StudyPictures> pictures;
  if (plots)
    pictures.emplace(*plots, quiet);
  std::vector<StudyFile> files;
  std::vector<Statement> statements;
  // First what takes longest, and what may be refused.
  if (flags.only != "models") {
    const PackingStudy study = packing_study(options, folder);
    files = packing_files(study, pictures);
    statements = packing_statements(study);
  }
  if (flags.only != "packings") {
    Answers answers(options.threads, quiet);
    std::vector<StudyFile> more = model_files(answers, pictures, statements);
    std::move(more.begin(), more.end(), std::back_inserter(files));
  }
  files.push_back({"statements.csv", statements_table(statements)});
  write_all(folder, files);
  return Exit::done;
}

} // namespace mdm::cli
