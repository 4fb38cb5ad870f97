# SPDX-License-Identifier: BSD-3-Clause
"""Readers of meshes that share no code with surfmesh, and counts of the formats it only writes."""

import dataclasses
import json
import re
import struct
import xml.etree.ElementTree

import numpy as np


@dataclasses.dataclass
class Mesh:
    """Points, and faces by their numbers of corners: arrays of (faces, corners) indices."""

    points: np.ndarray
    faces: dict

    def counts(self):
        return len(self.points), sum(len(f) for f in self.faces.values())


def mesh_of(points, faces):
    by_size = {}
    for face in faces:
        by_size.setdefault(len(face), []).append(face)
    points = np.array(points, float).reshape(-1, 3)
    return Mesh(points, {k: np.array(f, int) for k, f in sorted(by_size.items())})


def read_obj(path):
    points, faces = [], []
    with open(path, encoding="utf-8") as file:
        for line in file:
            words = line.split()
            if words[:1] == ["v"]:
                points.append([float(x) for x in words[1:4]])
            elif words[:1] == ["f"]:
                faces.append([int(x.split("/")[0]) - 1 for x in words[1:]])
    return mesh_of(points, faces)


def read_off(path):
    with open(path, encoding="utf-8") as file:
        words = [w for line in file for w in line.split("#")[0].split()]
    if words[0] != "OFF":
        raise ValueError("no OFF")
    n, m, at = int(words[1]), int(words[2]), 4
    points = [[float(x) for x in words[at + 3 * i:at + 3 * i + 3]] for i in range(n)]
    at, faces = at + 3 * n, []
    for _ in range(m):
        k = int(words[at])
        faces.append([int(x) for x in words[at + 1:at + 1 + k]])
        at += 1 + k
    if at != len(words):
        raise ValueError("numbers behind the last face")
    return mesh_of(points, faces)


def read_ply(path):
    with open(path, encoding="utf-8") as file:
        lines = file.read().split("\n")
    head = lines.index("end_header")
    if lines[:2] != ["ply", "format ascii 1.0"]:
        raise ValueError("no PLY of text")
    n, m = (int(re.search(rf"^element {name} (\d+)$", "\n".join(lines[:head]), re.M)[1])
            for name in ("vertex", "face"))
    points = [[float(x) for x in line.split()[:3]] for line in lines[head + 1:head + 1 + n]]
    faces = []
    for line in lines[head + 1 + n:head + 1 + n + m]:
        words = [int(x) for x in line.split()]
        faces.append(words[1:1 + words[0]])
    if "".join(lines[head + 1 + n + m:]):
        raise ValueError("lines behind the last face")
    return mesh_of(points, faces)


READERS = {"obj": read_obj, "off": read_off, "ply": read_ply}

NUMBERS = {"Float64": "<f8", "Int64": "<i8", "Int32": "<i4", "UInt8": "u1"}


def read_piece(path):
    """The arrays of a piece by their names: raw bytes behind the XML."""
    with open(path, "rb") as file:
        content = file.read()
    begin = content.index(b"<AppendedData encoding=\"raw\">\n_")
    text = content[:begin].decode()
    raw = content[begin + len("<AppendedData encoding=\"raw\">\n_"):]
    root = xml.etree.ElementTree.fromstring(text + "</VTKFile>")
    arrays = {}
    for element in root.iter("DataArray"):
        kind, at = np.dtype(NUMBERS[element.get("type")]), int(element.get("offset"))
        size = struct.unpack_from("<Q", raw, at)[0]
        arrays[element.get("Name")] = np.frombuffer(raw, kind, size // kind.itemsize, at + 8)
    piece = root.find(".//Piece")
    arrays["counts"] = np.array([int(piece.get(k)) for k in ("NumberOfPoints", "NumberOfCells")])
    arrays["points"] = arrays["points"].reshape(-1, 3)
    return arrays


def piece_faces(arrays):
    """The faces of a piece, as lists of its points."""
    ends = arrays["offsets"]
    return [arrays["connectivity"][a:b] for a, b in zip(np.concatenate([[0], ends]), ends)]


# ------------------------------------------------------------------- formats that are only written
def count_lines(path, word):
    with open(path, encoding="latin-1") as file:
        return sum(line.startswith(word) for line in file)


def inp_counts(path):
    """Nodes and elements: lines of numbers behind the keyword that begins them."""
    counts, keyword = {"*NODE": 0, "*ELEMENT": 0}, None
    with open(path, encoding="latin-1") as file:
        for line in file:
            if line.startswith("**"):
                continue
            if line.startswith("*"):
                keyword = line.split(",")[0].strip().upper()
            elif keyword in counts:
                counts[keyword] += 1
    return counts["*NODE"], counts["*ELEMENT"]


def bdf_counts(path):
    return count_lines(path, "GRID"), count_lines(path, "CTRIA3") + count_lines(path, "CQUAD4")


def vtk_counts(path):
    with open(path, "rb") as file:
        content = file.read()
    points = re.search(rb"^POINTS (\d+) ", content, re.M)
    cells = re.search(rb"^(?:CELL_TYPES|POLYGONS) (\d+)", content, re.M)
    return int(points[1]), int(cells[1])


def glb_triangles(path):
    with open(path, "rb") as file:
        content = file.read()
    size = struct.unpack_from("<I", content, 12)[0]
    if struct.unpack_from("<4sII", content) != (b"glTF", 2, len(content)):
        raise ValueError("no glTF 2 of this length")
    scene = json.loads(content[20:20 + size])
    corners = sum(scene["accessors"][p["indices"]]["count"]
                  for mesh in scene["meshes"] for p in mesh["primitives"])
    return corners // 3
