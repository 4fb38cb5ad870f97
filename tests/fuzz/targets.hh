// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

/// What is fuzzed: functions of any bytes. They throw a Finding, or anything else, only for a fault
/// of the library, and return whether it took the bytes; false if it refused them with an Error.
namespace surfmesh::fuzz {

using Bytes = std::span<const std::uint8_t>;

/// A law that does not hold.
class Finding : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// Read a control cage: its format, its options, the file. One that is accepted has to become a
/// model of surfaces that can be evaluated.
bool try_cage(Bytes bytes);

/// Read a model file, whose cages and tables are those of seed_files(), and estimate its mesh.
bool try_model(Bytes bytes);

/// Read formulas, a line each, of which the last may use those before. Values at all orders agree,
/// and bounds hold them.
bool try_formula(Bytes bytes);

/// Read a table of sizes or a background mesh: its kind, the file. What is accepted has to answer
/// with sizes.
bool try_table(Bytes bytes);

/// Read a mesh: its format, the one to write it in, the file. One that is accepted is proper, and
/// reads back as it was written.
bool try_result(Bytes bytes);

/// Read a CAD file: its format, the file. One that is accepted has to become a model of surfaces
/// that can be evaluated.
bool try_cad(Bytes bytes);

/// Make a small model, sizes and options of numbers, and mesh it. The mesh is sound after each
/// stage.
bool try_pipeline(Bytes bytes);

struct Target {
  std::string_view name;  ///< of its program, fuzz_NAME, and its folders
  bool (*run)(Bytes bytes) = nullptr;
};

/// All of those that are built: `cad` needs OpenCASCADE.
std::vector<Target> targets();

/// An input to start from.
struct Seed {
  std::string name;
  std::string bytes;
};

/// The seeds of a target: of models/ and of meshes in all formats.
std::vector<Seed> seeds_of(std::string_view target);

/// Those of the target `cad`, made with OpenCASCADE.
std::vector<Seed> cad_seeds();

/// What model files of try_model may name, as they lie beside them.
std::vector<Seed> seed_files();

}  // namespace surfmesh::fuzz
