#pragma once

#include <gmpxx.h>

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace mdm::checker {

/// A number of a certificate, and its text there.
struct Number {
  mpq_class value;
  std::string_view text;
};
using Numbers = std::vector<Number>;

/// `quantity` particles of class `index`, counted from 1, of one size in [lo, hi]; for a tolerance with their
/// mass, else 0.
struct ClassWitness {
  std::uint64_t index;
  mpz_class quantity;
  mpq_class mass, lo, hi;
};

/// Consecutive classes from i to j; i = j for one class.
struct ClassRange {
  std::uint64_t i, j;
  friend auto operator<=>(const ClassRange &, const ClassRange &) = default;
};

/// m > 0 times the condition of a letter and its classes (section 6), 0 to 0 where it has none.
struct Multiple {
  mpz_class m;
  char condition;
  ClassRange classes;
  /// What it counts in the limits 2 and 5: the sum d has a term for each of its classes.
  std::uint64_t terms() const { return condition == 'd' ? classes.j - classes.i + 1 : 1; }
};

/// A node of a tree: a split of the particles in some classes into fewer than v and at least v, one of the
/// mass into at most v and more than v, or a leaf, which with version 3 can be that of a window of the mass.
struct TreeNode {
  enum Kind { split, split_of_mass, leaf, window };
  Kind kind = leaf;
  ClassRange classes{0, 0};        ///< of a split of particles
  mpq_class v = 0;                 ///< of a split
  std::vector<Multiple> multiples; ///< of a leaf
  bool is_split() const { return kind == split || kind == split_of_mass; }
};

/// The numbers of each line; none where the line is absent. The texts are those of the file.
struct Certificate {
  Numbers law;          ///< a/b; a number 1 of a law by table or sum
  Numbers nodes, terms; ///< a size and a mass each, or a factor and an exponent
  Numbers pan_size, cut_below, size_factor, min_per_class, cylinder, box, solids_volume, pi, at_least;
  Numbers retained, retained_file, passing, passing_file, passing_each, total; ///< `file` is a number 0
  Numbers band;                                                                ///< three a line
  Numbers band_file;                                                           ///< a number 0, as above
  Numbers particles;                                                           ///< of the witness; or none
  Numbers bound; ///< no match has fewer: `particles`, or what a bound says; none: there is no match
  Numbers scale, above;
  std::vector<ClassWitness> classes;
  std::optional<std::vector<std::uint32_t>> chain; ///< 2^32 - 1 is an index that no class has
  std::vector<TreeNode> tree;                      ///< in preorder; empty without a tolerance
  unsigned version;                                ///< 1 to 3
  unsigned long a, b;                              ///< of the law; 1 and 1 by table or sum
  std::uint64_t law_work;                          ///< e of the limits, over d
  std::uint64_t longest_count;                     ///< in bits, for the limits 1 and 2
};

/// Reads a certificate (section 1).
Certificate read_certificate(std::string_view text);

} // namespace mdm::checker
