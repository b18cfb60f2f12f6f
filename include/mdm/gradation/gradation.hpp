#pragma once
/// \file
/// The grain size distribution G = (X_G, M_G).

#include <mdm/gradation/root_size.hpp>
#include <mdm/gradation/size_unit.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace mdm {

/// The largest root of a gradation.
inline constexpr unsigned max_root = 1000;

/// The remedy where openings must be fractions: convert the file.
inline constexpr std::string_view convert_remedy =
    "mdm convert writes the openings in mm, rounded to 15 digits";

struct Material;

/// The rows begin, ..., end - 1 of a gradation, counted from 0, that are those of one material.
struct MaterialRows {
  std::string name;
  std::size_t begin = 0, end = 0;
};

/// G of Arnold, Eq. 5-8, complete (Cond1, Eq. 9): openings x_1 < ... < x_n and the masses m_1, ..., m_n
/// retained on them, n >= 2, x_1 >= 0 (0 is the pan), m_j >= 0, m_n = 0, not all masses 0. Class j = 1, ...,
/// n - 1 holds the particles with x_j < x <= x_{j+1}: open below, closed above (Eq. 12). Openings are
/// fractions in all files but those of phi that is no whole number, where their d-th powers are; d is the
/// root. One of several materials (Theorem 28), which `mdm solve`, `batch`, `verify` and `export` read, has
/// rows of one material behind those of another: openings ascend within each, and its last row retains
/// nothing and begins no class.
class Gradation {
public:
  /// The parts of a gradation; vectors of n entries, ascending by size.
  struct Data {
    std::string id;               ///< name for reports, any text
    SizeUnit unit = SizeUnit::mm; ///< unit of the sizes
    std::vector<Rational> sizes;  ///< X_G, to the power `root`
    std::vector<Rational> masses; ///< M_G, in any unit: only their ratios count
    std::vector<Rational>
        factors; ///< density or shape factor c_j > 0 of class j (the last is not used), or empty: all 1
    std::vector<Rational> tolerances; ///< percentage points >= 0 as a file gave them, or empty
    std::vector<Rational> roundings;  ///< half a unit of the last digit of what passes, percent, or empty
    std::vector<std::string> notes;   ///< what the reader assumed, for the report
    unsigned root = 1;                ///< d, from 1 to max_root
    std::string file_unit = {};       ///< `inches` or `phi` where the file has its sizes so; else empty
  };

  /// \throws InputError naming the size where an invariant of the class does not hold
  explicit Gradation(Data data);
  /// Of fractions; Rational(0.075) is what the double holds, a little less than parse_decimal("0.075").
  /// \throws InputError as above
  Gradation(std::vector<Rational> sizes, std::vector<Rational> masses, SizeUnit unit = SizeUnit::mm,
            std::string id = "");

  const std::string &id() const { return data_.id; }
  SizeUnit unit() const { return data_.unit; }
  /// `inches` or `phi` where the file has its sizes so and they were converted; else empty.
  const std::string &file_unit() const { return data_.file_unit; }
  /// d: openings are the d-th roots of fractions.
  unsigned root() const { return data_.root; }
  /// x_j^d of all openings.
  const std::vector<Rational> &powers() const { return data_.sizes; }
  /// X_G.
  /// \throws InputError if d > 1: such openings are irrational, and where only fractions will do they are
  /// refused, not rounded
  const std::vector<Rational> &sizes() const {
    require_fractions();
    return data_.sizes;
  }
  RootSize opening(std::size_t j) const { return {data_.sizes[j], data_.root}; }
  /// An opening as a decimal: exactly, or the nearest of 15 significant digits.
  std::string opening_text(std::size_t j) const;
  bool has_pan() const { return data_.sizes.front().sign() == 0; }
  const std::vector<Rational> &masses() const { return data_.masses; }
  const std::vector<Rational> &tolerances() const { return data_.tolerances; }
  const std::vector<Rational> &roundings() const { return data_.roundings; }
  const std::vector<std::string> &notes() const { return data_.notes; }
  /// Empty if all factors are 1.
  const std::vector<Rational> &factors() const { return data_.factors; }
  bool has_factors() const { return !data_.factors.empty(); }

  /// The materials; none: there is one, and it has no name.
  const std::vector<MaterialRows> &materials() const { return materials_; }
  /// The name of the material of row j; empty if it has none.
  const std::string &material(std::size_t j) const;
  /// The remedy where openings must be fractions; mdm convert takes but one material.
  std::string_view fractions_remedy() const {
    return materials_.empty() ? convert_remedy : "give the openings in mm";
  }
  /// False for the last row of a material, which begins no class.
  bool is_class(std::size_t j) const;

  /// k = n - 1; of several materials some j < k begin no class, and have no mass.
  std::size_t classes() const { return data_.sizes.size() - 1; }
  /// Bounds (lower, upper] and mass of class j, counted from 0.
  /// \throws InputError as sizes()
  const Rational &lower(std::size_t j) const { return sizes()[j]; }
  const Rational &upper(std::size_t j) const { return sizes()[j + 1]; }
  const Rational &mass(std::size_t j) const { return data_.masses[j]; }
  /// c_j of class j, or for j = k what the largest size's row says.
  Rational factor(std::size_t j) const { return has_factors() ? data_.factors[j] : Rational(1); }
  /// The class with mass that begins at the largest opening.
  std::size_t coarsest() const;

  /// The same gradation with its pan (x_1 = 0) taken as `size`.
  /// \throws InputError if there is no pan or `size` is not in (0, x_2)
  Gradation with_pan_size(const Rational &size) const;
  /// The same gradation without the classes below the opening that `size` names (RootSize::is_named_by);
  /// their mass is lost.
  /// \throws InputError if `size` is no opening below the largest, or no mass is left
  Gradation cut_below(const Rational &size) const;
  /// The same gradation without the classes below j, of which one from j on has mass.
  Gradation from_class(std::size_t j) const;
  /// The same gradation with every size multiplied by `factor` > 0.
  Gradation scaled(const Rational &factor) const;

  /// Throws what the constructor throws; for tests.
  void check_invariant() const;

private:
  friend Gradation joined(std::vector<Material> parts, const std::string &id);
  void require_fractions() const {
    if (data_.root != 1)
      refuse_roots();
  }
  [[noreturn]] void refuse_roots() const;
  std::vector<MaterialRows>::const_iterator material_of(std::size_t j) const;

  Data data_;
  std::vector<MaterialRows> materials_;
};

} // namespace mdm
