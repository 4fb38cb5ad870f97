// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "paper/laboratory.hh"

namespace surfmesh::paper {

/// A picture under the name of its file.
struct Figure {
  std::string file;
  std::string svg;
};

/// Their names, in their order.
std::vector<std::string> figure_names();

/// Figures 1 and 4 to 10 of the paper, by our meshes in the paper's way.
std::vector<Figure> draw_figures(Laboratory& laboratory);

}  // namespace surfmesh::paper
