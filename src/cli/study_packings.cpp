#include "cli/study_packings.hpp"

#include "files/deposit_journal.hpp"
#include "files/in_parallel.hpp"
#include "files/paths.hpp"
#include "files/progress_line.hpp"
#include "papers/packing_figures.hpp"
#include "papers/packing_tables.hpp"

#include <fmt/core.h>

#include <atomic>

namespace mdm::cli {
namespace {

/// Discs of a picture.
const Integer &snapshot_discs() {
  static const Integer n = 5000;
  return n;
}

/// A deposit that is asked for, and its place among the answers.
struct Wanted {
  DepositQuestion question;
  DepositFacts *facts;
};

/// The deposits of points that do not take too many discs. \pre the points stay where they are
std::vector<Wanted> wanted(std::vector<PackingPoint> &points, DepositRule rule,
                           const PackingStudyOptions &options) {
  std::vector<Wanted> all;
  for (PackingPoint &p : points) {
    if (!p.discs || *p.discs > options.terms.at_most)
      continue;
    p.deposits.resize(options.seeds);
    for (std::uint64_t i = 0; i < options.seeds; ++i)
      all.push_back({{p.shape, p.classing, p.span, rule, i + 1}, &p.deposits[i]});
  }
  return all;
}

std::vector<PackingPoint> dropped_points(const PackingStudy &study) {
  std::vector<PackingPoint> points;
  for (const PackingPoint &p : study.points)
    if (p.shape.a == 1 && p.shape.b == 1 && p.classing == Classing::geometric)
      points.push_back(p);
  return points;
}

Snapshot snapshot(const Rational &span) {
  PackingTerms terms;
  terms.at_least = snapshot_discs();
  return {span, deposited({{1, 1}, Classing::geometric, span, DepositRule::lowest, 1}, terms)};
}

} // namespace

PackingStudy packing_study(const PackingStudyOptions &options, const std::string &folder) {
  make_folder(folder);
  DepositJournal journal(folder, options.terms);
  PackingStudy study{options.terms, figure9_points(options.spans, options.terms), {}, {}};
  study.dropped = dropped_points(study);
  std::vector<Wanted> all = wanted(study.points, DepositRule::lowest, options);
  for (const Wanted &w : wanted(study.dropped, DepositRule::drop, options))
    all.push_back(w);
  std::atomic<std::size_t> done = 0;
  const ProgressLine progress([&] { return fmt::format("{} of {} deposits", done.load(), all.size()); },
                              options.quiet);
  in_parallel(all.size(), options.threads, [&](std::size_t i) {
    const std::string key = all[i].question.key();
    if (const DepositFacts *known = journal.find(key)) {
      *all[i].facts = *known;
    } else {
      *all[i].facts = deposit_facts(all[i].question, options.terms);
      journal.add({key, *all[i].facts});
    }
    ++done;
  });
  study.equal = equal_disc_facts(options.terms);
  return study;
}

std::vector<StudyFile> packing_files(const PackingStudy &study,
                                     const std::optional<StudyPictures> &pictures) {
  const ApollonianGasket gasket = ApollonianGasket::equal();
  const Rational most = 300;
  const Snapshot narrow = snapshot(ratio(2, 100));
  const std::vector<Snapshot> wide = {snapshot(ratio(42, 100)), snapshot(ratio(97, 100))};
  std::vector<StudyFile> files = {{"figure2.csv", gasket_table(gasket, most)},
                                  {"figure9.csv", figure9_table(study)},
                                  {"figure9-deposits.csv", deposits_table(study.points)},
                                  {"figure10.csv", discs_table({narrow})},
                                  {"figure10-cells.csv", cells_table(narrow.packing)},
                                  {"figure11.csv", discs_table(wide)}};
  if (pictures) {
    files.push_back(pictures->drawn("figure2", gasket_figure(gasket.packing(most), most)));
    files.push_back(pictures->drawn("figure9", fraction_figure(study)));
    files.push_back(pictures->drawn("figure10", regions_figure(narrow)));
    files.push_back(pictures->drawn("figure11", snapshots_figure(wide)));
  }
  return files;
}

} // namespace mdm::cli
