#include "ask/option_table.hpp"

#include "ask/blend.hpp"
#include "ask/crosscheck_options.hpp"
#include "ask/describe_options.hpp"
#include "ask/export_options.hpp"
#include "ask/generate.hpp"
#include "ask/pack.hpp"
#include "ask/plot.hpp"
#include "ask/reading_options.hpp"
#include "ask/solve_options.hpp"
#include "ask/suite_lines.hpp"
#include "ask/tradeoff_options.hpp"
#include "ask/verifier.hpp"
#include "text/json_writer.hpp"
#include "text/option_name.hpp"

#include <algorithm>

namespace mdm {
namespace {

const TableOption &row_of(const TableOption &row) {
  return row;
}

template <class Texts>
TableOption row_of(const OptionRow<Texts> &row) {
  return {row.name, row.values, row.kind, row.help, row.choices()};
}

/// The rows of some tables, one table after the other; of those with one name the first.
template <class... Tables>
std::vector<TableOption> rows_of(const Tables &...tables) {
  std::vector<TableOption> all;
  const auto add = [&all](const auto &table) {
    for (const auto &row : table)
      if (std::none_of(all.begin(), all.end(),
                       [&row](const TableOption &o) { return o.name == std::string_view(row.name); }))
        all.push_back(row_of(row));
  };
  (add(tables), ...);
  return all;
}

std::vector<TableOption> rows_of_solving() {
  return rows_of(SolveTexts::tolerance_options, SolveTexts::band_options, BudgetTexts::options,
                 SolveTexts::question_options, SolveTexts::search_options, GradationTexts::options,
                 SolveTexts::answer_options, SolveTexts::limit_options);
}

std::vector<TableOption> without(const std::string &name, std::vector<TableOption> rows) {
  rows.erase(
      std::remove_if(rows.begin(), rows.end(), [&](const TableOption &row) { return row.name == name; }),
      rows.end());
  return rows;
}

const char *name(OptionKind kind) {
  switch (kind) {
  case OptionKind::text:
    return "text";
  case OptionKind::number:
    return "number";
  case OptionKind::seconds:
    return "seconds";
  case OptionKind::file:
    return "file";
  case OptionKind::tolerances:
    return "tolerances";
  case OptionKind::texts:
    return "texts";
  default:
    return "flag";
  }
}

} // namespace

const std::vector<OptionsOfCommand> &option_table() {
  static const std::vector<OptionsOfCommand> table = {
      {"solve", rows_of_solving()},
      {"verify", rows_of(VerifyTexts::options, ParticleTexts::options, GradationTexts::options,
                         VerifyTexts::answer_options, PlaceTexts::options)},
      {"crosscheck",
       rows_of(CrosscheckTexts::options, SolveTexts::tolerance_options, SolveTexts::band_options,
               SolveTexts::question_options, GradationTexts::options, CrosscheckTexts::limit_options)},
      {"tradeoff", rows_of(TradeoffTexts::options)}, // and those of solve
      {"blend", without("target", rows_of(BlendTexts::question_options, BlendTexts::answer_options,
                                          BlendTexts::limit_options, ReadingTexts::options))},
      {"describe", rows_of(DescribeTexts::options, SoilTexts::options)},
      {"convert", rows_of(ReadingTexts::options)},
      // What a set, a packing or an export is of is no option of a module.
      {"generate", without("curve", rows_of(GenerateTexts::options, GenerateTexts::answer_options,
                                            ReadingTexts::options))},
      {"pack",
       without("sizes", rows_of(PackTexts::disc_options, ReadingTexts::options, PackTexts::gasket_options,
                                PackTexts::place_options, PackTexts::answer_options))},
      // Sizes in a file of particles have as many digits as its masses need.
      {"export",
       without("digits", rows_of(ExportTexts::options, ExportTexts::particle_options,
                                 ExportTexts::start_options, ExportTexts::model_options,
                                 ExportTexts::size_options, rows_of_solving(), ReadingTexts::options))},
      {"plot", without("digits", rows_of(PlotTexts::options, SoilTexts::options, rows_of_solving(),
                                         ReadingTexts::options))},
      {"suite", without("shard", rows_of(SuiteTexts::options))}}; // lines with a step are a shard
  return table;
}

std::string option_table_json() {
  JsonWriter json;
  json.begin_object();
  for (const OptionsOfCommand &of : option_table()) {
    json.key(of.command).begin_array();
    for (const TableOption &o : of.options) {
      json.begin_object().key("name").plain(o.name);
      json.key("keyword").plain(option(o.name, OptionSpelling::keyword));
      json.key("member").plain(option(o.name, OptionSpelling::member));
      json.key("kind").plain(name(o.kind)).key("values").plain(o.values);
      json.key("choices").strings(o.choices).key("help").string(o.help);
      json.end_object();
    }
    json.end_array();
  }
  return json.end_object().take() + "\n";
}

} // namespace mdm
