// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "surfmesh/core/error.hh"
#include "surfmesh/formula/formula.hh"
#include "surfmesh/io/json_node.hh"
#include "surfmesh/sizes/sizing.hh"

/// Values that come in several places of a model file. All functions throw InvalidInput with the
/// place for what does not fit.
namespace surfmesh {

using Constants = std::map<std::string, double>;

/// Call `make`, and put the place of the node in front of its errors.
template <class Make>
auto at_node(const JsonNode& node, Make make) {
  try {
    return make();
  } catch (const Error& error) {
    node.fail(error.what());
  }
}

/// Formulas that belong together, in an object with one key for each and `where` for those that
/// they use. The reader tells the fault of each at its own place, before the text is used.
class FormulaNode {
 public:
  /// Read `where`, if the object has it.
  FormulaNode(const JsonNode& node, const std::vector<std::string>& variables,
              const Constants& constants);

  /// The formula of a key, which must be there.
  std::string text(std::string_view key);
  /// The formula of a key; `otherwise` if it is not there.
  std::string text(std::string_view key, const std::string& otherwise);

  const std::vector<NamedFormula>& where() const { return where_; }

 private:
  JsonNode node_;
  FormulaReader reader_;
  std::vector<NamedFormula> where_;
};

/// Read a number, or a string with a constant expression.
double number_or_expression(const JsonNode& node, const Constants& constants);

/// Read a length above 0: a number, or a share of the diagonal as "1%".
Length read_length(const JsonNode& node);

/// Read a length that may be 0.
Length read_radius(const JsonNode& node);

/// Read the two bounds of one parameter.
std::pair<double, double> read_range(const JsonNode& node, const Constants& constants);

/// Read `size` and `angle` of a source.
Size read_size(const JsonNode& source);

/// Read the name of a patch or contour, which a loop can name.
std::string read_name(const JsonNode& node);

/// The one of these keys that a source has.
std::string kind_of(const JsonNode& source, std::span<const std::string_view> kinds);

}  // namespace surfmesh
