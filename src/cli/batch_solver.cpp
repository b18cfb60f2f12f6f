#include "cli/batch_solver.hpp"

#include "answer/answer.hpp"
#include "answer/batch_csv.hpp"
#include "answer/error_line.hpp"
#include "cli/match_proofs.hpp"
#include "files/interrupt.hpp"
#include "files/paths.hpp"
#include "gradation/material_gradation.hpp"
#include "text/json_writer.hpp"
#include "text/option_name.hpp"

#include <mdm/proof/certificate.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <new>
#include <utility>

namespace mdm::cli {
namespace {

/// Name of a proof without its ending: the number makes it unique and sorts it, the id makes it findable,
/// with `_` for what does not serve in a file name.
std::string proof_name(std::uint64_t number, const std::string &id) {
  constexpr std::size_t longest_id = 64;
  const auto is_plain = [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' ||
           c == '_' || c == '.';
  };
  std::string name = id.substr(0, longest_id);
  std::replace_if(
      name.begin(), name.end(), [&](char c) { return !is_plain(c); }, '_');
  return name.empty() || id == std::to_string(number) ? fmt::format("{:06}", number)
                                                      : fmt::format("{:06}-{}", number, name);
}

/// What standard error has beside the answer: CSV has no place for a verdict, a budget and notes.
std::string told(const Match &m, const OutputFlags &output) {
  if (output.verbose)
    return answer_text(m, nullptr, nullptr, true);
  if (!output.is_csv())
    return "";
  const std::string id = printable(m.gradation.id()) + ": ";
  std::string text = m.status == Status::optimal ? "" : id + headline(m) + "\n";
  if (output.quiet)
    return text;
  if (m.budget)
    text += id + budget_text(*m.budget) + "\n";
  for (const std::string &note : m.notes)
    text += id + "note: " + note + "\n";
  return text;
}

} // namespace

BatchSolver::BatchSolver(const BatchCommand &command)
    : command_(command),
      search_(command.flags, command.flags.budget, band_in_file, command.proofs.has_value()) {}

BatchAnswer BatchSolver::answer(const BatchItem &item) const {
  try {
    return solved(item.read(), item);
  } catch (const InputError &e) {
    return error(item.id(), e.what());
  } catch (const std::bad_alloc &) { // the others are none the worse for it
    return error(item.id(),
                 printable(item.where) + ": out of memory: give it more, or a " + option("max-steps"));
  }
}

BatchAnswer BatchSolver::error(const std::string &id, const std::string &message) const {
  if (command_.output.is_csv())
    return {"", Exit::bad_input, message + "\n"};
  return {error_line(id, message), Exit::bad_input};
}

BatchAnswer BatchSolver::solved(Gradation g, const BatchItem &item) const {
  if (!g.materials().empty())
    refuse_beside_materials(command_.flags.idle_for_materials(command_.flags.budget), item.where);
  if (command_.output.is_csv() && !g.materials().empty())
    throw InputError(printable(item.where) +
                     ": of several materials, for which the CSV has no column: leave it out, or give " +
                     option("format") + " json");
  const std::string checked = command_.has_proof_folder() && item.checked_as ? item.checked_as(g) : "";
  const ProgressCall go_on = [](const Progress &) { return !Interrupt::was_pressed(); };
  Found answered = in_file(item.where, [&] { return search_.ask(std::move(g), go_on); });
  Match &m = answered.match;
  if (Interrupt::was_pressed())
    note_stopped(m);
  std::string proof, certificate_text;
  if (command_.proofs && has_certificate(m)) {
    certificate_text = in_file(item.where, [&] { return noted_certificate(m); });
    if (command_.has_proof_folder())
      proof = write_proofs(std::exchange(certificate_text, {}), answered, item, checked);
    else if (answered.finer)
      m.notes.push_back("a stream of proofs does not hold that of the next finer step: give " +
                        option("proofs") + " a folder");
  } else if (command_.proofs) {
    m.notes.push_back("no proof was written: the limit came before the end");
  }
  BatchAnswer answer{command_.output.is_csv() ? batch_csv(m) : answer_json(m, nullptr, proof) + "\n",
                     exit_code(answered.outcome), told(m, command_.output)};
  if (command_.output.is_csv()) {
    answer.id = printable(m.gradation.id());
    answer.unit = name(m.gradation.unit());
  }
  answer.certificate = std::move(certificate_text);
  return answer;
}

/// \param checked the gradation file beside it, if there is to be one
/// \return the name of its file
std::string BatchSolver::write_proofs(const std::string &certificate, Found &found, const BatchItem &item,
                                      const std::string &checked) const {
  const std::string name = proof_name(item.number, found.match.gradation.id()), proof = name + ".proof";
  write_output(*command_.proofs + "/" + proof, certificate);
  if (const std::optional<std::string> finer = finer_certificate(found))
    write_output(*command_.proofs + "/" + finer_proof(proof), *finer);
  if (!checked.empty())
    write_output(*command_.proofs + "/" + name + ".gradation", checked);
  return proof;
}

} // namespace mdm::cli
