#pragma once
/// \file
/// Gradations of several materials, each of which has classes of its own with their factors.

#include <mdm/gradation/gradation.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace mdm {

/// A material with its gradation; the masses of all materials are in one unit.
struct Material {
  std::string name;
  Gradation gradation;
};

/// The gradation that has the classes of all the parts (Theorem 28), in their order.
/// \pre there is a part; names ascend; the parts have one unit and one root, and all or none have factors
Gradation joined(std::vector<Material> parts, const std::string &id);

/// The material of that name; null if g has none.
const MaterialRows *find_material(const Gradation &g, std::string_view name);

/// True for canonical CSV with the column material.
bool is_material_gradation(std::string_view content);

/// Reads such a file (proofs/certificate-format.md, section 14); materials ascend by the bytes of their
/// names.
/// \throws InputError with the line
Gradation read_material_gradation(std::string_view content, const std::string &file);

/// Refuses an option, as messages name it, beside a file of several materials; an empty one is not refused.
void refuse_beside_materials(const std::string &given, const std::string &file);

} // namespace mdm
