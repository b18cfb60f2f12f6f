// What --coq writes of a chain or a tree is what Coq's reader makes of the certificate's text.

#include "catch.hpp"
#include "checker/mutants.hpp"
#include "proof/coq_file.hpp"

#include <cstdlib>
#include <filesystem>

TEST_CASE("evidence is what Coq reads of the certificate, of every version") {
  std::string file = "From Coq Require Import ZArith QArith List String Ascii.\n"
                     "From Mdm Require Import Numbers Certificate Document.\n"
                     "Import ListNotations.\nOpen Scope Z_scope.\n"
                     "Definition read (text : string) : result proof :=\n"
                     "  let* c := read_certificate (words_of text) in Ok (proof_of c).\n";
  std::size_t chains = 0, leaves = 0, windows = 0;
  const auto holds = [](const std::string &text, const char *part) {
    return text.find(part) != std::string::npos ? 1U : 0U;
  };
  for (const auto &entry : std::filesystem::directory_iterator(MDM_CERTIFICATES_DIR "/accepted")) {
    if (entry.path().extension() != ".proof")
      continue;
    const std::string text = mdm_check_test::read_file(entry.path());
    // What `band file` stands for is in the gradation's file; numbers of many digits take Coq long.
    if (text.size() > 3000 || holds(text, "\nband file\n"))
      continue;
    chains += holds(text, "\nchain");
    leaves += holds(text, "\nleaf ");
    windows += holds(text, "\nwindow");
    file += "Goal read \"" + text + "\"%string =\n  Ok (" + mdm::coq_evidence(text) +
            ").\nProof. vm_compute. reflexivity. Qed.\n";
  }
  CHECK(chains > 40);
  CHECK(leaves > 40);
  CHECK(windows > 20);
  const mdm_check_test::TemporaryFolder folder;
  const std::string path = (folder.path() / "evidence.v").string();
  mdm_check_test::write_file(path, file);
  CHECK(std::system(("'" MDM_COQC "' -q -Q '" MDM_COQ_BUILD "' Mdm '" + path + "'").c_str()) == 0);
}
