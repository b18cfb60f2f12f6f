#include "papers/paper_tables.hpp"

#include "match/problem.hpp"
#include "text/text_table.hpp"

#include <mdm/number/decimal.hpp>

#include <fmt/core.h>

#include <functional>

namespace mdm {
namespace {

std::string cell(const Rational &r) {
  return approximate(r, 15);
}

std::string cell(const Real &y) {
  return rounded(y, 10);
}

template <class T>
std::string cell(const Available<T> &value) {
  return value ? cell(*value) : "";
}

std::string cell(const std::optional<Integer> &n) {
  return n ? to_string(*n) : "";
}

constexpr const char *counts_header =
    "n_exact,n_spanned_integer,n_spanned_integer_printed,n_fixed_size,n_rounded\n";

std::string counts_cells(const SurveyCounts &n) {
  return fmt::format("{},{},{},{},{}\n", to_string(n.exact), cell(n.spanned_integer),
                     cell(n.spanned_integer_printed), cell(n.fixed_size), to_string(n.rounded));
}

std::string zeta_cells(const Rational &zeta) {
  return cell(zeta) + "," + cell(log_ratio(PowerProduct(zeta), PowerProduct(10)));
}

bool is_less(const Rational &a, const Rational &b) {
  return a < b;
}

bool is_less(const Real &a, const Real &b) {
  return compare(a, b) == Order::less;
}

template <class T>
using Parameter = std::function<Available<T>(const SurveyRow &)>;

/// A row of Table 1; empty cells where no gradation has the parameter.
template <class T>
std::string extremes(const std::vector<SurveyRow> &rows, const char *name, const char *unit,
                     const Parameter<T> &parameter) {
  std::optional<T> least, greatest;
  std::string least_id, greatest_id;
  for (const SurveyRow &row : rows) {
    const Available<T> value = parameter(row);
    if (!value)
      continue;
    if (!least || is_less(*value, *least)) {
      least = *value;
      least_id = row.id;
    }
    if (!greatest || is_less(*greatest, *value)) {
      greatest = *value;
      greatest_id = row.id;
    }
  }
  return fmt::format("{},{},{},{},{},{}\n", name, unit, least ? cell(*least) : "",
                     greatest ? cell(*greatest) : "", csv_field(least_id), csv_field(greatest_id));
}

} // namespace

std::optional<std::size_t> figure1_example(const std::vector<SurveyRow> &rows) {
  const Rational papers = ratio(109, 100);
  std::optional<std::size_t> best;
  Rational distance;
  for (std::size_t i = 0; i < rows.size(); i += subset_step) {
    if (!rows[i].i_c)
      continue;
    const Enclosure i_c = enclose(*rows[i].i_c, 10);
    const Rational d = abs(i_c.lower() - papers);
    if (best && d >= distance)
      continue;
    best = i;
    distance = d;
  }
  return best;
}

std::string table1_csv(const std::vector<SurveyRow> &rows) {
  const auto exactly = [&rows](const char *name, const char *unit, const Parameter<Rational> &parameter) {
    return extremes<Rational>(rows, name, unit, parameter);
  };
  const auto really = [&rows](const char *name, Available<Real> SurveyRow::*member) {
    return extremes<Real>(rows, name, "", [member](const SurveyRow &row) { return row.*member; });
  };
  return "parameter,unit,least,greatest,least_id,greatest_id\n" +
         fmt::format("gradations,,{0},{0},,\n", rows.size()) +
         exactly("sieves", "", [](const SurveyRow &row) { return Rational(row.sizes.size()); }) +
         exactly("x_2", "mm", [](const SurveyRow &row) { return row.sizes[1]; }) +
         exactly("x_max", "mm", [](const SurveyRow &row) { return row.sizes.back(); }) +
         exactly("finest_class", "percent",
                 [](const SurveyRow &row) { return Rational(100 * row.finest_share); }) +
         really("C_c", &SurveyRow::c_c) + really("C_u", &SurveyRow::c_u) + really("I_GS", &SurveyRow::i_gs) +
         really("I_C", &SurveyRow::i_c) +
         exactly("phi_1", "", [](const SurveyRow &row) { return row.phi_1; }) +
         exactly("zeta_1", "", [](const SurveyRow &row) { return row.zeta_1; }) +
         exactly("n_exact", "particles", [](const SurveyRow &row) { return Rational(row.counts.exact); });
}

std::string figure1_csv(const std::vector<SurveyRow> &rows) {
  std::string text = "id,i_c,example,size_mm,passing_percent\n";
  const std::optional<std::size_t> example = figure1_example(rows);
  for (std::size_t i = 0; i < rows.size(); i += subset_step) {
    const SurveyRow &row = rows[i];
    const std::string begin =
        fmt::format("{},{},{},", csv_field(row.id), cell(row.i_c), example == i ? 1 : 0);
    for (std::size_t j = 0; j < row.sizes.size(); ++j)
      text += begin + cell(row.sizes[j]) + "," + cell(Rational(100 * row.passing[j])) + "\n";
  }
  return text;
}

std::string figure2_csv(const std::vector<Convergence> &runs) {
  std::string text = "id,algorithm,iteration,particles,total_error_percent\n";
  const auto add = [&text](const std::string &id, const char *algorithm, const Published &run) {
    for (const PublishedTry &t : run.tries)
      text += fmt::format("{},{},{},{},{}\n", csv_field(id), algorithm, t.multiple, to_string(total(t.q)),
                          cell(Rational(100 * t.error.total)));
  };
  for (const Convergence &c : runs) {
    add(c.id, "spanned-integer", c.spanned_integer);
    add(c.id, "fixed-size", c.fixed_size);
  }
  return text;
}

std::string figure3_csv(const std::vector<SurveyRow> &rows) {
  std::string text = "id,phi_1,zeta_1,log10_zeta_1,";
  text += counts_header;
  for (const SurveyRow &row : rows)
    text += csv_field(row.id) + "," + cell(row.phi_1) + "," + zeta_cells(row.zeta_1) + "," +
            counts_cells(row.counts);
  return text;
}

std::string figure4_csv(const std::vector<SurveyRow> &rows) {
  std::string text = "id,i_c,zeta_1,log10_zeta_1,";
  text += counts_header;
  for (const SurveyRow &row : rows)
    text += csv_field(row.id) + "," + cell(row.i_c) + "," + zeta_cells(row.zeta_1) + "," +
            counts_cells(row.counts);
  return text;
}

std::string figure5_csv(const std::vector<SurveyRow> &rows) {
  std::string text = "id,i_gs,group_symbol,group_name,";
  text += counts_header;
  for (const SurveyRow &row : rows)
    text += csv_field(row.id) + "," + cell(row.i_gs) + "," + (row.group ? row.group->symbol : "") + "," +
            (row.group ? csv_field(row.group->name) : "") + "," + counts_cells(row.counts);
  return text;
}

} // namespace mdm
