#include "sample_certificate.hpp"

#include "law.hpp"
#include "question_lines.hpp"

#include <mdm/checker.hpp>

namespace mdm::checker {
namespace {

constexpr std::string_view first_line = "mdm-certificate sample 1";

/// The lines of a certificate of a sample.
class SampleLines : public QuestionLines {
public:
  explicit SampleLines(std::string_view text) : QuestionLines(text, "mdm verify") {}

  Percents percents() {
    Percents read{number('z'), number('z')};
    check(read.lo.value <= read.hi.value, "percents that do not ascend: give the lower one first");
    return read;
  }

  ClassClaim class_claim() {
    ClassClaim claim{index(), number('0').value.get_num(), {}, false};
    const std::string_view first = word();
    claim.is_exact = !more();
    if (claim.is_exact) {
      claim.share.lo = claim.share.hi = number('q', first);
      return claim;
    }
    claim.share = {number('z', first), number('z')};
    check(claim.share.lo.value < claim.share.hi.value,
          "percents that do not ascend: give the lower one first, or one alone where it is exact");
    return claim;
  }

  LargestError largest_error(std::string_view name) {
    demand(name);
    LargestError error;
    error.index = index();
    error.percents = percents();
    end();
    return error;
  }

  std::array<std::string_view, 4> conditions() {
    demand("conditions");
    std::array<std::string_view, 4> words;
    for (std::string_view &condition : words) {
      condition = word();
      check(condition == "yes" || condition == "no" || condition == "open",
            "a condition that is none of yes, no and open: write one of them");
    }
    end();
    return words;
  }

  SampleVerdict verdict() {
    demand("verdict");
    SampleVerdict verdict;
    const bool is_match = take(" match");
    if (is_match || take(" outside")) {
      verdict.kind = is_match ? SampleVerdict::match : SampleVerdict::outside;
      end();
      return verdict;
    }
    const std::string_view of = word();
    verdict.kind = of == "class"     ? SampleVerdict::of_class
                   : of == "passing" ? SampleVerdict::passing
                                     : SampleVerdict::total;
    check(verdict.kind != SampleVerdict::total || of == "total",
          "no verdict: write match, outside, class, passing or total");
    if (verdict.kind != SampleVerdict::total)
      verdict.index = index();
    verdict.found = percents();
    const std::string_view side = word();
    verdict.is_least = side == "least";
    check(side == "most" || (verdict.is_least && verdict.kind != SampleVerdict::total),
          "no side: write least or most, of the total most");
    verdict.asked = number('z');
    end();
    return verdict;
  }
};

} // namespace

bool is_sample_certificate(std::string_view text) {
  return text.substr(0, text.find('\n')) == first_line;
}

SampleCertificate read_sample_certificate(std::string_view text) {
  SampleLines lines(text);
  SampleCertificate c;
  lines.demand(first_line);
  lines.end();
  c.question.version = 1;
  read_law_and_openings(lines, c.question);
  lines.check_before(is_power(c.question),
                     "a law by table or sum, of which there is no certificate of a sample");
  c.is_tolerant = read_tolerance(lines, c.question);
  c.question.longest_count = lines.longest_count();
  lines.read_if_there("places", "0", c.places);
  lines.check_before(c.places.empty() || c.places[0].value <= 1000, "more than 1000 places: give fewer");
  lines.read("particles", "1", c.particles);
  lines.read_if_there("below", "1", c.below);
  lines.read_if_there("above", "1", c.above);
  lines.read_if_there("unplaced", "1", c.unplaced);
  while (lines.take("class")) {
    lines.check(c.classes.size() < most_classes, "more classes than a gradation can have: drop some");
    c.classes.push_back(lines.class_claim());
    lines.end();
  }
  c.retained = lines.largest_error("retained-error");
  if (lines.begins_with("passing-error"))
    c.passing = lines.largest_error("passing-error");
  lines.demand("total-error");
  c.total = lines.percents();
  lines.end();
  c.conditions = lines.conditions();
  c.verdict = lines.verdict();
  lines.demand("end");
  lines.end_file();
  return c;
}

} // namespace mdm::checker
