#include "cli/batch_solver.hpp"

#include "answer/answer.hpp"
#include "answer/batch_csv.hpp"
#include "answer/error_line.hpp"
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

/// CSV has no place for a verdict and for notes.
BatchAnswer csv_answer(const Match &m, Outcome outcome) {
  const std::string id = printable(m.gradation.id());
  std::string told = m.status == Status::optimal ? "" : id + ": " + headline(m) + "\n";
  for (const std::string &note : m.notes)
    told += id + ": note: " + note + "\n";
  return {batch_csv(m), exit_code(outcome), told, id, std::string(name(m.gradation.unit()))};
}

} // namespace

BatchSolver::BatchSolver(const BatchCommand &command)
    : command_(command), question_(command.flags, band_in_file, command.proofs.has_value()) {}

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
    refuse_beside_materials(command_.flags.idle_for_materials().value_or(""), item.where);
  if (command_.output.is_csv() && !g.materials().empty())
    throw InputError(printable(item.where) +
                     ": of several materials, for which the CSV has no column: leave it out, or give " +
                     option("format") + " json");
  const std::string checked = command_.has_proof_folder() && item.checked_as ? item.checked_as(g) : "";
  const ProgressCall go_on = [](const Progress &) { return !Interrupt::was_pressed(); };
  BatchMatch answered = in_file(item.where, [&] { return question_.ask(std::move(g), go_on); });
  Match &m = answered.match;
  if (!m.complete && Interrupt::was_pressed())
    m.notes.push_back("the search was interrupted");
  std::string proof, certified;
  if (command_.proofs && has_certificate(m)) {
    certified = in_file(item.where, [&] { return certificate(m); });
    if (command_.has_proof_folder())
      proof = write_proof(std::exchange(certified, {}), item, m.gradation.id(), checked);
  } else if (command_.proofs) {
    m.notes.push_back("no proof was written: the limit came before the end");
  }
  BatchAnswer answer = command_.output.is_csv()
                           ? csv_answer(m, answered.outcome)
                           : BatchAnswer{answer_json(m, nullptr, proof) + "\n", exit_code(answered.outcome)};
  answer.certificate = std::move(certified);
  return answer;
}

/// \param checked the gradation file beside it, if there is to be one
/// \return the name of its file
std::string BatchSolver::write_proof(const std::string &certificate, const BatchItem &item,
                                     const std::string &id, const std::string &checked) const {
  const std::string name = proof_name(item.number, id);
  write_output(*command_.proofs + "/" + name + ".proof", certificate);
  if (!checked.empty())
    write_output(*command_.proofs + "/" + name + ".gradation", checked);
  return name + ".proof";
}

} // namespace mdm::cli
