#include "blend/blend_certificate.hpp"
#include "catch.hpp"

#include <mdm/checker.hpp>
#include <mdm/gradation/read_gradation.hpp>

#include <algorithm>
#include <random>
#include <sstream>

namespace blend_certificate_test {

using namespace mdm;

namespace {

/// A problem as files.
struct BlendFiles {
  std::string limits;
  std::vector<std::string> stockpiles;
};

/// `tenths` of a percent as a decimal.
std::string percent(int tenths) {
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10);
}

/// 2 to 4 stockpiles on some of the sieves 1, 2, 4, 8 mm, with 16 above them, and limits at all of these.
BlendFiles random_files(std::mt19937_64 &random) {
  const auto upto = [&random](unsigned most) { return static_cast<int>(random() % (most + 1)); };
  BlendFiles files;
  std::vector<int> middle(4, 0);
  const int stockpiles = 2 + upto(2);
  for (int i = 0; i < stockpiles; ++i) {
    std::vector<int> passing(4);
    for (int &p : passing)
      p = upto(1000);
    std::sort(passing.begin(), passing.end());
    passing[0] = upto(2) == 0 ? 0 : passing[0];
    std::string text = "size_mm,passing_percent\n16,100\n";
    for (int s = 3; s >= 0; --s)
      if (s == 0 || upto(4) != 0)
        text += std::to_string(1 << s) + "," + percent(passing[static_cast<std::size_t>(s)]) + "\n";
    for (std::size_t s = 0; s < 4; ++s)
      middle[s] += passing[s] / stockpiles;
    files.stockpiles.push_back(text);
  }
  files.limits = "size_mm,passing_min_percent,passing_max_percent\n16,100,100\n";
  for (std::size_t s = 0; s < 4; ++s)
    files.limits += std::to_string(1 << s) + "," + percent(std::max(0, middle[s] - upto(150))) + "," +
                    percent(std::min(1000, middle[s] + upto(150))) + "\n";
  return files;
}

BlendProblem problem_of(const BlendFiles &files, std::mt19937_64 &random) {
  const auto upto = [&random](unsigned most) { return static_cast<int>(random() % (most + 1)); };
  std::vector<Gradation> stockpiles;
  for (std::size_t i = 0; i < files.stockpiles.size(); ++i)
    stockpiles.push_back(read_gradation(files.stockpiles[i], std::to_string(i) + ".csv"));
  BlendProblem p = blend_problem(stockpiles, read_envelope(files.limits, "limits.csv"), stockpiles.front());
  p.steps = static_cast<std::uint64_t>(10 + upto(20));
  p.aim = static_cast<BlendAim>(upto(3));
  for (Stockpile &s : p.stockpiles) {
    s.cost = ratio(upto(50), 4);
    if (upto(6) == 0)
      s.most = ratio(5, 7);
    if (upto(6) == 0)
      s.least = ratio(1, 9);
  }
  if (upto(4) == 0)
    p.at_most = static_cast<std::size_t>(1 + upto(1));
  return p;
}

checker::Verdict verdict(const BlendFiles &files, const std::string &certificate) {
  std::vector<checker::Input> stockpiles;
  for (std::size_t i = 0; i < files.stockpiles.size(); ++i)
    stockpiles.push_back({std::to_string(i) + ".csv", files.stockpiles[i]});
  return checker::check_blend({"limits.csv", files.limits}, stockpiles, {"proof", certificate});
}

std::vector<std::string> words_of(const std::string &line) {
  std::istringstream in(line);
  std::vector<std::string> words;
  for (std::string word; in >> word;)
    words.push_back(word);
  return words;
}

/// The certificate with its line `blend ...` replaced.
std::string with_blend(const std::string &certificate, const std::string &line) {
  const std::size_t from = certificate.find("\nblend ") + 1;
  return certificate.substr(0, from) + line + certificate.substr(certificate.find('\n', from));
}

} // namespace

TEST_CASE("the proofs of random problems of blends are accepted") {
  std::mt19937_64 random(5);
  int blends = 0, none = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const BlendFiles files = random_files(random);
    const BlendProblem p = problem_of(files, random);
    const BlendAnswer a = solve_blend(p);
    const std::string certificate = blend_certificate(p, a);
    const checker::Verdict v = verdict(files, certificate);
    INFO(trial << "\n" << files.limits << certificate << v.reason);
    CHECK(v.code == checker::Verdict::accepted);
    (a.best.empty() ? none : blends) += 1;
  }
  CHECK(blends > 50);
  CHECK(none > 50);
}

TEST_CASE("a proof does not serve a blend of greater value, nor that there is none") {
  std::mt19937_64 random(6);
  int forged = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const BlendFiles files = random_files(random);
    const BlendProblem p = problem_of(files, random);
    BlendOptions o;
    o.best = 6;
    const BlendAnswer a = solve_blend(p, o);
    if (a.best.size() < 2 || p.aim == BlendAim::none)
      continue;
    const std::string certificate = blend_certificate(p, a);
    for (const Blend &blend : a.best) {
      std::string line = "blend";
      for (const Rational &share : blend.shares)
        line += " " + to_string(Rational(share * p.steps));
      const bool is_best = blend.value == a.best.front().value;
      INFO(trial << "\n" << certificate << line);
      CHECK((verdict(files, with_blend(certificate, line)).code == checker::Verdict::accepted) == is_best);
      forged += !is_best;
    }
    std::string empty = with_blend(certificate, "blend none");
    for (std::size_t at; (at = empty.find("\nleaf")) != std::string::npos;)
      empty.replace(at, 5, "\nnone");
    CHECK(verdict(files, empty).code != checker::Verdict::accepted);
  }
  CHECK(forged > 100);
}

TEST_CASE("a proof whose multipliers are gone proves nothing where they were needed") {
  std::mt19937_64 random(7);
  int refused = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const BlendFiles files = random_files(random);
    const BlendProblem p = problem_of(files, random);
    const BlendAnswer a = solve_blend(p);
    if (!a.contradiction || p.at_most)
      continue;
    std::istringstream lines(blend_certificate(p, a));
    std::string bare;
    for (std::string line; std::getline(lines, line);)
      bare += (line.rfind("none ", 0) == 0 ? words_of(line).front() : line) + "\n";
    const bool of_shares =
        std::all_of(a.contradiction->limits.begin(), a.contradiction->limits.end(),
                    [](const BlendMultiple &m) { return m.limit.kind == BlendLimit::Kind::share; });
    CHECK((verdict(files, bare).code == checker::Verdict::accepted) == of_shares);
    ++refused;
  }
  CHECK(refused > 10);
}

} // namespace blend_certificate_test
