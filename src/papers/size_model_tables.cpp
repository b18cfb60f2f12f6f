#include "papers/size_model_tables.hpp"

#include <mdm/number/decimal.hpp>

#include <fmt/core.h>

namespace mdm {
namespace {

constexpr unsigned model_digits = 10;

std::string cells(const Shape &shape) {
  return to_decimal(shape.a) + "," + to_decimal(shape.b);
}

} // namespace

std::string table_csv(const std::vector<DistributionRow> &rows) {
  std::string text = "size_mm,number_density,volume_density,partition,grading\n";
  for (const DistributionRow &r : rows)
    text += fmt::format("{},{},{},{},{}\n", to_decimal(r.size), rounded(r.number_density, model_digits),
                        rounded(r.volume_density, model_digits), rounded(r.partition, model_digits),
                        rounded(r.grading, model_digits));
  return text;
}

std::string table_csv(const std::vector<PassingRow> &rows) {
  std::string text = "a,b,reduced_size,passing\n";
  for (const PassingRow &r : rows)
    text +=
        fmt::format("{},{},{}\n", cells(r.shape), to_decimal(r.reduced), rounded(r.passing, model_digits));
  return text;
}

std::string table_csv(const std::vector<CoefficientRow> &rows) {
  std::string text = "a,b,span,C_u,C_c\n";
  for (const CoefficientRow &r : rows)
    text += fmt::format("{},{},{},{}\n", cells(r.shape), to_decimal(r.span), rounded(r.c_u, model_digits),
                        rounded(r.c_c, model_digits));
  return text;
}

std::string table_csv(const std::vector<SetRow> &rows) {
  std::string text =
      "a,b,classing,classes,min_per_class,at_least,n_estimated,n,draws,C_r,C_r_least,C_r_greatest\n";
  for (const SetRow &r : rows) {
    const SetQuestion &q = r.question;
    const IntegerBounds estimated = r.counts.estimated();
    const auto c_r = [&r](Interval (SetRow::*value)() const) {
      return r.c_r.empty() ? "" : rounded(real_in((r.*value)()), model_digits);
    };
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", cells(q.shape), name(q.classing), q.classes,
                        to_string(q.wanted.min_per_class), to_string(q.wanted.at_least),
                        estimated.is_point() ? to_string(estimated.lo) : "",
                        r.counts.decided() ? to_string(r.counts.particles()) : "", r.c_r.size(),
                        c_r(&SetRow::mean), c_r(&SetRow::least), c_r(&SetRow::greatest));
  }
  return text;
}

std::string table_csv(const std::vector<ShapeRow> &rows) {
  std::string text = "classing,span,a,b,particles,C_u\n";
  for (const ShapeRow &r : rows)
    text += fmt::format("{},{},{},{},{}\n", name(r.question.classing), to_decimal(r.question.span),
                        cells(r.question.shape), to_string(r.particles), rounded(r.c_u, model_digits));
  return text;
}

} // namespace mdm
