#include "answer/json_values.hpp"
#include "report/blend_report.hpp"
#include "text/versions.hpp"

namespace mdm {
namespace {

const char *status_of_blend(BlendAnswer::Status status) {
  switch (status) {
  case BlendAnswer::Status::optimal:
    return "optimal";
  case BlendAnswer::Status::feasible:
    return "feasible";
  case BlendAnswer::Status::none:
    return "none";
  default:
    return "unknown";
  }
}

void write_limit(JsonWriter &json, const BlendMultiple &m, const BlendProblem &p) {
  const char *const of[] = {"passing", "target", "share", "sum"};
  const bool is_passing = m.limit.kind == BlendLimit::Kind::passing;
  const bool is_modulus = is_passing && p.sieves[m.limit.index].modulus;
  const bool is_coarseness = is_passing && p.sieves[m.limit.index].coarseness;
  json.begin_object().key("of").plain(is_modulus      ? "modulus"
                                      : is_coarseness ? "coarseness"
                                                      : of[static_cast<std::size_t>(m.limit.kind)]);
  json.key("name");
  if (m.limit.kind == BlendLimit::Kind::share)
    json.string(p.stockpiles[m.limit.index].name);
  else if (m.limit.kind == BlendLimit::Kind::sum)
    json.null();
  else if (is_modulus)
    json.plain(name(*p.sieves[m.limit.index].modulus));
  else if (is_coarseness)
    json.plain(to_string(*p.sieves[m.limit.index].coarseness));
  else
    json.plain(to_string(p.sieves[m.limit.index].size));
  json.key("side").plain(m.limit.kind == BlendLimit::Kind::sum ? "equal"
                         : m.limit.is_upper                    ? "most"
                                                               : "least");
  write(json.key("value"), value_of(m.limit, p));
  write(json.key("multiplier"), m.multiplier).end_object();
}

void write_limits(JsonWriter &json, const std::vector<BlendMultiple> &multiples, const BlendProblem &p) {
  json.begin_array();
  for (const BlendMultiple &m : multiples)
    write_limit(json, m, p);
  json.end_array();
}

void write_rationals(JsonWriter &json, const std::vector<Rational> &numbers) {
  json.begin_array();
  for (const Rational &n : numbers)
    write(json, n);
  json.end_array();
}

/// What passes the sieves, and the fineness moduli that are limited.
void write_passing(JsonWriter &json, const std::vector<Rational> &passing, const BlendProblem &p) {
  json.key("passing").begin_array();
  for (std::size_t s = 0; s < passing.size(); ++s)
    if (p.sieves[s].is_sieve())
      write(json, passing[s]);
  json.end_array().key("moduli").begin_array();
  for (std::size_t s = 0; s < passing.size(); ++s)
    if (const std::optional<FinenessModulus> modulus = p.sieves[s].modulus)
      write(json, modulus_of_mean(*modulus, passing[s]));
  json.end_array();
}

void write_blend(JsonWriter &json, const Blend &blend, const BlendProblem &p) {
  write_rationals(json.begin_object().key("shares"), blend.shares);
  write_passing(json, blend.passing, p);
  if (p.coarseness)
    write(json.key("coarseness"), coarseness_factor(p, blend.shares));
  write(json.key("value"), blend.value).key("broken").begin_array();
  for (const BlendLimit &limit : broken_limits(p, blend))
    json.string(in_words(limit, p));
  json.end_array().end_object();
}

void write_blend(JsonWriter &json, const std::optional<Blend> &blend, const BlendProblem &p) {
  if (blend)
    write_blend(json, *blend, p);
  else
    json.null();
}

void write_bailey(JsonWriter &json, const BaileyReport &b) {
  const BaileyRatios ratios = bailey_ratios(b.passing);
  write(json.key("bailey").begin_object().key("nominal"), b.sieves.nominal);
  write_rationals(json.key("sieves"),
                  {b.sieves.half, b.sieves.primary, b.sieves.secondary, b.sieves.tertiary});
  write_rationals(json.key("passing"), {b.passing.begin(), b.passing.end()});
  write(json.key("CA"), ratios.coarse);
  write(json.key("FAc"), ratios.fine_coarse);
  write(json.key("FAf"), ratios.fine_fine);
  json.key("interpolated").boolean(b.is_interpolated).end_object();
}

void write_problem(JsonWriter &json, const BlendProblem &p) {
  json.key("stockpiles").begin_array();
  for (const Stockpile &s : p.stockpiles) {
    json.begin_object().key("name").string(s.name);
    write_passing(json, s.passing, p);
    if (p.coarseness) {
      write(json.key("coarse").begin_array(), s.coarse->at_9_5_mm);
      write(json, s.coarse->at_2_36_mm);
      json.end_array();
    }
    write(json.key("least"), s.least);
    write(json.key("most"), s.most);
    write(json.key("cost"), s.cost).end_object();
  }
  json.end_array().key("sieves").begin_array();
  for (const BlendSieve &s : p.sieves) {
    if (!s.is_sieve())
      continue;
    write(json.begin_object().key("size"), s.size);
    write(json.key("least"), s.least);
    write(json.key("most"), s.most);
    write(json.key("target"), s.target).end_object();
  }
  json.end_array().key("moduli").begin_array();
  for (const BlendSieve &s : p.sieves)
    if (s.modulus) {
      json.begin_object().key("name").plain(name(*s.modulus));
      write(json.key("least"), modulus_of_mean(*s.modulus, s.most));
      write(json.key("most"), modulus_of_mean(*s.modulus, s.least)).end_object();
    }
  json.end_array();
  if (p.coarseness) {
    write(json.key("coarseness").begin_object().key("least"), p.coarseness->least);
    write(json.key("most"), p.coarseness->most).end_object();
  }
  json.key("steps").number(p.steps).key("at_most");
  if (p.at_most)
    json.number(*p.at_most);
  else
    json.null();
  json.key("aim").plain(name(p.aim));
}

} // namespace

std::string blend_json(const BlendReport &r) {
  const BlendAnswer &a = r.answer;
  JsonWriter json;
  json.begin_object().key("schema").plain("mdm-blend-1");
  if (!r.id.empty())
    json.key("id").string(r.id);
  json.key("specification").string(r.specification);
  json.key("status").plain(status_of_blend(a.status)).key("unit").plain("mm");
  write_problem(json, r.problem);
  json.key("blends").begin_array();
  for (const Blend &blend : a.best)
    write_blend(json, blend, r.problem);
  json.end_array().key("all").boolean(a.is_all).key("bound");
  if (a.status == BlendAnswer::Status::none)
    json.null();
  else
    write(json, a.bound);
  json.key("splits").number(a.splits);
  write_blend(json.key("real"), a.real, r.problem);
  write_limits(json.key("prices"), a.prices, r.problem);
  write_blend(json.key("rounded"), a.rounded, r.problem);
  json.key("contradiction");
  if (a.contradiction) {
    write_limits(json.begin_object().key("limits"), a.contradiction->limits, r.problem);
    write(json.key("sum"), a.contradiction->sum);
    write(json.key("excess"), a.contradiction->excess).end_object();
  } else {
    json.null();
  }
  write_blend(json.key("widened_real"), a.widened_real, r.problem);
  write_blend(json.key("widened"), a.widened, r.problem);
  if (r.bailey)
    write_bailey(json, *r.bailey);
  json.key("notes").strings(r.problem.notes).key("versions").raw(versions_json()).end_object();
  return json.take();
}

} // namespace mdm
