#include "files/counted_files.hpp"

#include "files/byte_source.hpp"
#include "files/file_totals.hpp"
#include "files/paths.hpp"
#include "text/filesystem_path.hpp"
#include "text/option_name.hpp"

#include <mdm/text/error.hpp>

#include <unistd.h>

#include <cerrno>
#include <filesystem>

namespace mdm {
namespace {

/// The name of a file from the folder of the answers.
std::string name_beside(const std::string &answers, const std::string &file) {
  const std::filesystem::path folder = filesystem_path(canonical_path(answers)).parent_path();
  const std::filesystem::path beside = filesystem_path(canonical_path(file)).lexically_relative(folder);
  return path_name(beside.generic_u8string());
}

NamedFileTotals totals_of(Output &output, const std::string &name) {
  return {{output.digest().bytes(), output.digest().sha256()}, name};
}

/// Refuses what is no regular file, nor to be one. \param name of the option that has the path
void check_is_file(const std::string &path, const std::string &name) {
  if (is_stream(path))
    throw InputError(name + " " + printable(path) + ": no file, and totals are of files: name a file with " +
                     name);
}

/// \return the lock of the answers
std::string lock_path(const std::string &answers, const std::optional<std::string> &proofs) {
  check_is_file(answers, "-o");
  if (proofs)
    check_is_file(*proofs, option("proofs"));
  return answers + ".lock";
}

} // namespace

std::string totals_path(const std::string &answers) {
  return answers + ".totals";
}

Totals read_totals_of(const std::string &answers) {
  constexpr std::size_t most_bytes = std::size_t{1} << 20;
  const std::string path = totals_path(answers);
  return read_totals(read_file(path, most_bytes), path);
}

std::string path_beside(const std::string &answers, const NamedFileTotals &file) {
  return path_name(filesystem_path(answers).parent_path() / filesystem_path(file.name));
}

CountedFiles::CountedFiles(std::string answers, std::optional<std::string> proofs)
    : answers_path_(std::move(answers)), proofs_path_(std::move(proofs)),
      lock_(lock_path(answers_path_, proofs_path_)) {}

std::optional<Totals> CountedFiles::complete() const {
  try {
    Totals t = read_totals_of(answers_path_);
    const auto is_there = [this](const std::string &path, const NamedFileTotals &file) {
      return file.name == name_beside(answers_path_, path) && file_bytes(path) == file.bytes &&
             file_totals(path) == FileTotals{file.bytes, file.sha256};
    };
    const bool has_proofs = proofs_path_ ? t.proofs && t.index && is_there(*proofs_path_, *t.proofs) &&
                                               is_there(proof_index_path(*proofs_path_), *t.index)
                                         : !t.proofs;
    if (has_proofs && is_there(answers_path_, t.answers))
      return t;
  } catch (const InputError &) { // they are written anew
  }
  return std::nullopt;
}

void CountedFiles::open() {
  for (const std::string &path : {answers_path_, totals_path(answers_path_)})
    remove_leftovers(path);
  answers_.emplace(answers_path_);
  answers_->keep_digest();
  if (proofs_path_) {
    remove_leftovers(*proofs_path_);
    remove_leftovers(proof_index_path(*proofs_path_));
    proofs_.emplace(*proofs_path_, true);
  }
}

void CountedFiles::commit(Totals totals) {
  const std::string path = totals_path(answers_path_);
  Output totals_file(path);
  if (unlink(path.c_str()) != 0 && errno != ENOENT)
    refuse_file(path, "cannot be removed", errno, "remove it");
  answers_->commit_durably();
  totals.answers = totals_of(*answers_, name_beside(answers_path_, answers_path_));
  if (proofs_) {
    proofs_->commit_durably();
    totals.proofs = totals_of(proofs_->stream(), name_beside(answers_path_, *proofs_path_));
    totals.index = totals_of(proofs_->index(), name_beside(answers_path_, proof_index_path(*proofs_path_)));
  }
  totals_file.write(totals_json(totals) + "\n");
  totals_file.commit_durably();
}

} // namespace mdm
