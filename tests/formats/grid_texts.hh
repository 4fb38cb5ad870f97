// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <string>

namespace surfmesh {

/// A quad and a triangle of the second order, a line, a point; two entities, of which one is in two
/// groups; a view at nodes. Numbers of nodes have gaps.
inline constexpr const char* kMsh22 = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$Comments
anything $Elements
$EndComments
$PhysicalNames
3
1 1 "the rim"
2 2 "one"
2 3 "all of it"
$EndPhysicalNames
$Nodes
8
10 0 0 0
20 1 0 0
30 1 1 0
40 0 1 0
50 2 0.5 0
60 1.5 0.25 0
70 1.5 0.75 0
80 1 0.5 0
$EndNodes
$Elements
5
1 15 2 0 1 10
2 1 2 1 4 10 20
3 3 2 2 5 10 20 30 40
4 3 2 3 5 10 20 30 40
5 9 2 3 6 20 50 30 60 70 80
$EndElements
$NodeData
1
"h"
1
0.0
3
0
1
3
10 0.5
20 0.25
50 1e-3
$EndNodeData
)";

/// The same, in version 4.1.
inline constexpr const char* kMsh41 = R"($MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
3
1 1 "the rim"
2 2 "one"
2 3 "all of it"
$EndPhysicalNames
$Entities
1 1 2 0
1 0 0 0 0
4 0 0 0 1 0 0 1 1 0
5 0 0 0 1 1 0 2 2 3 1 4
6 1 0 0 2 1 0 1 3 0
$EndEntities
$Nodes
2 8 10 80
0 1 0 1
10
0 0 0
2 5 1 7
20
30
40
50
60
70
80
1 0 0 0.1 0.2
1 1 0 0.1 0.2
0 1 0 0.1 0.2
2 0.5 0 0.1 0.2
1.5 0.25 0 0.1 0.2
1.5 0.75 0 0.1 0.2
1 0.5 0 0.1 0.2
$EndNodes
$Elements
4 4 1 5
0 1 15 1
1 10
1 4 1 1
2 10 20
2 5 3 1
3 10 20 30 40
2 6 9 1
5 20 50 30 60 70 80
$EndElements
$NodeData
1
"h"
1
0.0
3
0
1
3
10 0.5
20 0.25
50 1e-3
$EndNodeData
)";

inline constexpr const char* kMedit = R"(MeshVersionFormatted 2
Dimension 3
# A quad, a triangle and an edge.
Vertices
5
0 0 0 1
1 0 0 1
1 1 0 1
0 1 0 1
2 0.5 0 1
Corners 1
1
Edges
2
1 2 4
2 3 0
Quadrilaterals 1
1 2 3 4 5
Triangles
1
2 5 3 9
RequiredVertices
2
1 2
End
)";

inline constexpr const char* kSol = R"(MeshVersionFormatted 2
Dimension 3
SolAtVertices
5
3 1 2 3
0.1 9 9 9 1 2 3 4 5 6
0.2 9 9 9 1 2 3 4 5 6
0.3 9 9 9 1 2 3 4 5 6
0.4 9 9 9 1 2 3 4 5 6
0.5 9 9 9 1 2 3 4 5 6
End
)";

inline constexpr const char* kVtu = R"(<?xml version="1.0"?>
<VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian">
  <UnstructuredGrid>
    <FieldData><DataArray type="Float64" Name="TimeValue" format="ascii">1</DataArray></FieldData>
    <Piece NumberOfPoints="5" NumberOfCells="4">
      <PointData Scalars="h">
        <DataArray type="Float32" Name="h" format="ascii">0.5 0.25 1 2
          NaN</DataArray>
      </PointData>
      <CellData>
        <DataArray type="Int8" Name="patch" format="ascii">0 2 1 1</DataArray>
        <DataArray type="String" Name="words" format="ascii">65 0</DataArray>
      </CellData>
      <Points>
        <DataArray type="Float64" NumberOfComponents="3" format="ascii">
          0 0 0  1 0 0  1 1 0  0 1 0  2 0.5 0
        </DataArray>
      </Points>
      <Cells>
<DataArray type="Int64" Name="connectivity" format="ascii">0 1  0 1 3 2  1 4 2  0 1 2 4</DataArray>
        <DataArray type="Int32" Name="offsets" format="ascii">2 6 9 13</DataArray>
        <DataArray type="UInt8" Name="types" format="ascii">3 8 5 10</DataArray>
      </Cells>
    </Piece>
  </UnstructuredGrid>
</VTKFile>
)";

/// Makes the bytes of a binary file.
class Bytes {
 public:
  explicit Bytes(std::endian order) : order_(order) {}

  Bytes& text(const std::string& text) {
    bytes_ += text;
    return *this;
  }

  template <class Number>
  Bytes& add(Number number) {
    std::array<char, sizeof(Number)> raw;
    std::memcpy(raw.data(), &number, raw.size());
    if (order_ != std::endian::native) std::reverse(raw.begin(), raw.end());
    bytes_.append(raw.data(), raw.size());
    return *this;
  }

  template <class Number, class... Numbers>
  Bytes& all(Numbers... numbers) {
    (add(static_cast<Number>(numbers)), ...);
    return *this;
  }

  const std::string& done() const { return bytes_; }
  std::size_t size() const { return bytes_.size(); }

 private:
  std::endian order_;
  std::string bytes_;
};

}  // namespace surfmesh
