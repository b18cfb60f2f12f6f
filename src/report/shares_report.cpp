#include "report/shares_report.hpp"

#include "report/description_items.hpp"
#include "text/json_writer.hpp"
#include "text/text_buffer.hpp"
#include "text/text_table.hpp"
#include "text/versions.hpp"

#include <mdm/match/tolerance.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

namespace mdm {
namespace {

const char *kind_name(ShareOf kind) {
  return kind == ShareOf::mass ? "mass" : "number";
}

const char *other_name(const ClassShares &s) {
  return kind_name(s.given == ShareOf::mass ? ShareOf::number : ShareOf::mass);
}

/// The ends of a share in percent.
std::pair<std::string, std::string> percent_ends(const RealRange &share, unsigned digits) {
  const auto end = [digits](const Real &y, bool is_upper) -> std::string {
    if (y.fraction() == Rational(0))
      return "0";
    const auto bounds = *bounds_of({"", "", "%", RealRange{Real(100) * y, Real(100) * y}, true}, digits);
    return is_upper ? bounds.second : bounds.first;
  };
  return {end(share.lo, false), end(share.hi, true)};
}

/// The given share of class j in percent.
Rational given_percent(const ClassShares &s, std::size_t j) {
  return 100 * shares(s.gradation)[j];
}

} // namespace

ClassShares class_shares(Gradation gradation, ShareOf given) {
  std::vector<RealRange> other = other_shares(GradingCurve(gradation), given);
  return {std::move(gradation), given, std::move(other)};
}

std::string shares_text(const ClassShares &s, unsigned digits) {
  const Gradation &g = s.gradation;
  const std::string unit(name(g.unit())), other(other_name(s));
  std::vector<std::vector<std::string>> rows = {{"above (" + unit + ")", "up to (" + unit + ")",
                                                 std::string(kind_name(s.given)) + " (%)",
                                                 other + " (%) from", "to"}};
  for (std::size_t j = 0; j < g.classes(); ++j) {
    auto [from, to] = percent_ends(s.other[j], digits);
    rows.push_back({g.opening_text(j), g.opening_text(j + 1), approximate(given_percent(s, j), 7), from, to});
  }
  std::string text =
      fmt::format("{}: shares of the {} from those of the {}, of spheres of one density.\n"
                  "A particle may have any size of its class: the shares of the {} lie in ranges.\n\n",
                  printable(g.id()), other, kind_name(s.given), other);
  text += text_table(rows, ">");
  for (const std::string &note : g.notes())
    text += "  note: " + note + "\n";
  return text;
}

std::string shares_json(const ClassShares &s, unsigned digits) {
  const Gradation &g = s.gradation;
  JsonWriter json;
  json.begin_object().key("schema").plain("mdm-shares-1").key("id").string(g.id());
  json.key("given").plain(kind_name(s.given)).key("unit").plain(name(g.unit()));
  json.key("classes").begin_array();
  for (std::size_t j = 0; j < g.classes(); ++j) {
    const auto [from, to] = percent_ends(s.other[j], digits);
    json.begin_object().key("lower").plain(g.opening_text(j)).key("upper").plain(g.opening_text(j + 1));
    json.key(fmt::format("{}_percent", kind_name(s.given))).plain(approximate(given_percent(s, j), digits));
    json.key(fmt::format("{}_percent", other_name(s))).begin_array().plain(from).plain(to).end_array();
    json.end_object();
  }
  json.end_array().key("notes").strings(g.notes()).key("versions").raw(versions_json());
  return json.end_object().take();
}

std::string shares_csv(const ClassShares &s, unsigned digits) {
  const Gradation &g = s.gradation;
  TextBuffer out;
  add(out, "lower_{0},upper_{0},{1}_percent,{2}_percent_lo,{2}_percent_hi\n", name(g.unit()),
      kind_name(s.given), other_name(s));
  for (std::size_t j = 0; j < g.classes(); ++j) {
    const auto [from, to] = percent_ends(s.other[j], digits);
    add(out, "{},{},{},{},{}\n", g.opening_text(j), g.opening_text(j + 1),
        approximate(given_percent(s, j), digits), from, to);
  }
  return fmt::to_string(out);
}

} // namespace mdm
