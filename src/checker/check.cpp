#include "check.hpp"

#include "verify.hpp"

#include <algorithm>

namespace mdm_check {
namespace {

/// The verdict repeats the question: its reader sees what was proved.
std::string accepted(const Certificate &certificate, const std::string &file) {
  std::string text;
  const auto say = [&](std::string_view words, const Numbers &numbers) {
    auto number = numbers.begin();
    for (const char c : numbers.empty() ? std::string_view() : words)
      text += c == '#' ? std::string((number++)->text) : std::string{c};
  };
  say("accepted: N = # is the least number of particles", certificate.particles);
  text += certificate.particles.empty() ? "accepted: no sample" : "";
  say(" from # up", certificate.at_least);
  const bool tolerant = !certificate.tree.empty();
  text += (certificate.particles.empty() ? " matches " : " that matches ") + printable(file) +
          (tolerant ? " within a tolerance (" : " exactly (");
  say("retained #%; ", certificate.retained);
  say("retained as the file has it; ", certificate.retained_file);
  say("passing #%; ", certificate.passing);
  say("passing as the file has it; ", certificate.passing_file);
  for (const Number &number : certificate.passing_each)
    say(&number == &certificate.passing_each[0] ? "passing #%" : ", #%", {number});
  say("; ", certificate.passing_each);
  say("total #%; ", certificate.total);
  for (std::size_t i = 0; i < certificate.band.size(); i += 3)
    say("#: # to #% passing; ", {certificate.band[i], certificate.band[i + 1], certificate.band[i + 2]});
  say(certificate.law[0].value.get_den() == 1 ? "law x^#" : "law x^(#)", certificate.law);
  say("; at least # particles in each class", certificate.min_per_class);
  say("; solids of the cylinder # x # at void ratio #", certificate.cylinder);
  say("; solids of the box # x # x # at void ratio #", certificate.box);
  say("; solids of at least the volume #", certificate.solids_volume);
  say("; openings multiplied by #", certificate.size_factor);
  say("; classes below # left out", certificate.cut_below);
  say("; pan counted as size #", certificate.pan_size);
  return text + ")";
}

} // namespace

Verdict check(const Input &gradation_file, const Input &certificate_file) {
  const Input *reading = &gradation_file;
  try {
    Gradation gradation = read_gradation(gradation_file.text);
    reading = &certificate_file;
    const Certificate certificate = read_certificate(certificate_file.text);
    const auto verify = certificate.tree.empty() ? verify_exact : verify_tolerant;
    verify(std::move(gradation), certificate);
    return {Verdict::accepted, accepted(certificate, gradation_file.name)};
  } catch (const Refused &reason) {
    return {Verdict::refused, std::string("refused: ") + reason.what()};
  } catch (const Malformed &error) {
    const auto line = 1 + std::count(reading->text.data(), error.at, '\n');
    return {Verdict::malformed, printable(reading->name) + ":" + std::to_string(line) + ": " + error.what()};
  }
}

} // namespace mdm_check
