#include "check.hpp"

#include "certificate.hpp"
#include "gradation.hpp"
#include "problem.hpp"
#include "verify.hpp"

namespace mdm_check {
namespace {

/// The question in words: a reader of the verdict sees what was proved.
std::string question_in_words(const Question &question) {
  const std::vector<Number> &d = question.dimensions;
  std::string words = "law x^" + (question.b == 1 ? std::to_string(question.a)
                                                  : "(" + std::to_string(question.a) + "/" +
                                                        std::to_string(question.b) + ")");
  if (question.min_per_class)
    words += "; at least " + question.min_per_class->get_str() + " particles in each class";
  if (question.solids == Solids::cylinder)
    words += "; solids of the cylinder " + d[0].text + " x " + d[1].text + " at void ratio " + d[2].text;
  if (question.solids == Solids::box)
    words += "; solids of the box " + d[0].text + " x " + d[1].text + " x " + d[2].text + " at void ratio " +
             d[3].text;
  if (question.solids == Solids::volume)
    words += "; solids of at least the volume " + d[0].text;
  if (question.size_factor)
    words += "; openings multiplied by " + question.size_factor->text;
  if (question.cut_below)
    words += "; classes below " + question.cut_below->text + " left out";
  if (question.pan_size)
    words += "; pan counted as size " + question.pan_size->text;
  return words;
}

} // namespace

Verdict check(const Input &gradation_file, const Input &certificate_file) {
  const Input *reading = &gradation_file;
  try {
    Gradation gradation = read_gradation(gradation_file.text);
    reading = &certificate_file;
    const Certificate certificate = read_certificate(certificate_file.text);
    const Problem problem = derive(std::move(gradation), certificate);
    verify(problem, certificate);
    const Question &question = certificate.question;
    return {Verdict::accepted,
            "accepted: N = " + certificate.particles.get_str() + " is the least number of particles" +
                (question.at_least ? " from " + question.at_least->get_str() + " up" : std::string()) +
                " that matches " + printable(gradation_file.name) + " exactly (" +
                question_in_words(question) + ")"};
  } catch (const Refused &reason) {
    return {Verdict::refused, std::string("refused: ") + reason.what()};
  } catch (const Malformed &error) {
    return {Verdict::malformed,
            printable(reading->name) + ":" + std::to_string(error.line) + ": " + error.what()};
  }
}

} // namespace mdm_check
