#include "cli/known_minima.hpp"

#include "files/paths.hpp"
#include "files/proof_stream.hpp"
#include "proof/question_text.hpp"
#include "text/lines.hpp"

#include <mdm/checker.hpp>
#include <mdm/gradation/write_gradation.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <sstream>

namespace mdm::cli {
namespace {

constexpr std::size_t most_proof_bytes = std::size_t{1} << 30;
constexpr std::string_view particles_word = "\nparticles ";

/// The lines of a certificate that say what was asked, without those of `pi`, which are no part of it.
std::string question_in(const std::string &certificate) {
  const std::size_t begin = certificate.find('\n') + 1, end = certificate.find(particles_word) + 1;
  std::istringstream lines(certificate.substr(begin, end - begin));
  std::string text;
  for (std::string line; std::getline(lines, line);)
    if (!line.starts_with("pi "))
      text += line + "\n";
  return text;
}

Integer number_in(const std::string &digits) {
  const std::optional<Integer> n = parse_natural(digits);
  if (!n)
    throw InputError("the number " + in_quotes(digits) + " of a certificate is none");
  return *n;
}

/// The claim of a certificate that was accepted: `N`, `B..N`, `B..` or `none`.
KnownMinimum claim_in(const std::string &certificate) {
  const std::size_t begin = certificate.find(particles_word) + particles_word.size();
  const std::string claim = certificate.substr(begin, certificate.find('\n', begin) - begin);
  if (claim == "none")
    return {1, std::nullopt, true};
  const std::size_t dots = claim.find("..");
  const std::string most = dots == std::string::npos ? claim : claim.substr(dots + 2);
  return {number_in(claim.substr(0, dots)), most.empty() ? std::nullopt : std::optional(number_in(most)),
          false};
}

} // namespace

KnownMinima::KnownMinima(const std::string &stream)
    : path_(shown_name(stream)), stream_(read_file(stream, most_proof_bytes)) {
  const std::string index = proof_index_path(stream), text = read_file(index, most_proof_bytes);
  const std::string_view header = proof_index_header;
  if (!text.starts_with(header))
    throw file_error(index, "this is no index of proofs: give the file that mdm batch --proofs wrote");
  std::istringstream lines(text.substr(header.size()));
  std::size_t end = 0;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream numbers(line);
    std::uint64_t number = 0;
    Place place{};
    numbers >> number >> place.offset >> place.length;
    if (!numbers || place.offset != end || place.length > stream_.size() - end)
      throw file_error(index, in_quotes(line) + " is none of a certificate in " + path_ + ": make both anew");
    end += place.length;
    places_[number] = place;
  }
}

std::string KnownMinima::certificate(std::uint64_t line) const {
  const auto found = places_.find(line);
  return found == places_.end() ? "" : stream_.substr(found->second.offset, found->second.length);
}

std::optional<KnownMinimum> KnownMinima::of(const SuiteLine &line, const Question &question) const {
  const std::string text = certificate(line.line);
  if (text.empty())
    return std::nullopt;
  const std::string name = fmt::format("{}: the certificate of line {}", path_, line.line);
  const checker::Verdict verdict =
      checker::check({"the gradation", gradation_csv(line.gradation)}, {name, text});
  if (verdict.code != checker::Verdict::accepted)
    throw InputError(verdict.reason + ": make the proofs anew for this suite");
  if (question_in(text) != asked_lines(line.gradation, question))
    throw InputError(name + " is of another question" +
                     (verdict.question.empty() ? "" : ", " + verdict.question) +
                     ": give the proofs of this one, by mdm batch with the same options");
  return claim_in(text);
}

} // namespace mdm::cli
