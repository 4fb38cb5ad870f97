# SPDX-License-Identifier: BSD-3-Clause
"""What is asked of what a run wrote: its own file, its pieces, or the files of all formats."""

import json
import os

import numpy as np

import mesh_files
from judge import area_and_volume, judge

READABLE = ["obj", "ply", "off", "stl", "vtu", "msh", "mesh", "meshb"]
WRITTEN_ONLY = ["vtk", "glb", "inp", "bdf"]
VERSIONS = ["4.1", "4.1-text", "2.2", "2.2-text"]
# Single precision, in shares of what is compared; what rounding leaves of sums of doubles.
SINGLE, DOUBLE = 1e-4, 1e-9


class Fault(Exception):
    """What a step found; the text tells the kind and the place."""


def expect(status, result, what):
    if result.status == "timeout":
        raise Fault(f"timeout of {what}")
    if result.status not in status:
        raise Fault(f"{what}: exit {result.status}: {result.err.strip()[-300:]}")
    return result


def expect_same(name, found, wanted, share=0.0):
    if abs(found - wanted) > share * abs(wanted):
        raise Fault(f"{name} {found!r} not {wanted!r}")


def expect_sound(mesh, case, is_complete, what):
    bad = judge(mesh, case.known, is_complete, case.quads)
    if bad:
        raise Fault(f"{what}: " + "; ".join(bad))


def check_by_program(run, folder, name, mesh, is_complete, more=()):
    """`check` has no fault, and finds the counts and the area that we do."""
    result = expect((0, 3), run(["check", name, "--json", *more], folder), f"check {name}")
    found = json.loads(result.out)
    kinds = sorted(f["kind"] for f in found["faults"])
    if is_complete and kinds:
        raise Fault(f"check {' '.join([name, *more[:1]])}: {kinds}")
    if mesh is None:
        return found
    vertices, faces = mesh.counts()
    expect_same(f"{name}: vertices of check", found["counts"]["vertices"], vertices)
    counted = sum(found["counts"][k] for k in ("triangles", "quads", "polygons"))
    expect_same(f"{name}: faces of check", counted, faces)
    return found


def check_report(folder, mesh):
    with open(os.path.join(folder, "report.json"), encoding="utf-8") as file:
        report = json.load(file)["mesh"]
    vertices, faces = mesh.counts()
    expect_same("vertices of the report", report["vertices"], vertices)
    expect_same("faces of the report", report["triangles"] + report["quads"], faces)


# ---------------------------------------------------------------------------- one file
def ask_mesh(case, run, folder, is_complete):
    mesh = mesh_files.READERS[case.ending](os.path.join(folder, "out." + case.ending))
    expect_sound(mesh, case, is_complete, "mesh")
    check_report(folder, mesh)
    check_by_program(run, folder, "out." + case.ending, mesh, is_complete)
    return mesh


# ---------------------------------------------------------------------------- pieces
def joined(folder):
    """The mesh of all pieces in a folder, joined by the ids of vertices."""
    names = sorted(n for n in os.listdir(folder) if n.endswith(".vtu"))
    pieces = [mesh_files.read_piece(os.path.join(folder, n)) for n in names]
    ids = np.concatenate([p["GlobalNodeIds"] for p in pieces])
    points = np.concatenate([p["points"] for p in pieces])
    order, first, inverse = np.unique(ids, return_index=True, return_inverse=True)
    if len(order) == 0 or (order != np.arange(len(order))).any():
        raise Fault("ids of vertices are not 0, 1, 2, ...")
    if (points[first][inverse].view(np.int64) != points.view(np.int64)).any():
        raise Fault("a vertex has other coordinates in another piece")
    check_neighbours(pieces)
    faces = [p["GlobalNodeIds"][f] for p in pieces for f in mesh_files.piece_faces(p)]
    return mesh_files.mesh_of(points[first], faces)


def check_neighbours(pieces):
    """Both pieces list the same vertices in the same order, and all that they share."""
    for i, piece in enumerate(pieces):
        shared, ends = {}, piece["neighbour_offsets"]
        for other, a, b in zip(piece["neighbour_pieces"], ends, ends[1:]):
            shared[int(other)] = piece["GlobalNodeIds"][piece["neighbour_vertices"][a:b]]
        for j, other in enumerate(pieces):
            if j == i:
                continue
            both = np.intersect1d(piece["GlobalNodeIds"], other["GlobalNodeIds"])
            if set(both) != set(shared.get(j, [])):
                raise Fault(f"pieces {i} and {j} share other vertices than are told")
            if len(both) == 0:
                continue
            at = list(other["neighbour_pieces"]).index(i)
            back = other["neighbour_vertices"][other["neighbour_offsets"][at]:
                                               other["neighbour_offsets"][at + 1]]
            if (other["GlobalNodeIds"][back] != shared[j]).any():
                raise Fault(f"pieces {i} and {j} list shared vertices in two orders")


def face_keys(mesh):
    """Faces by the bits of their corners, begun at the least of them; sorted."""
    rows = []
    for faces in mesh.faces.values():
        for face in mesh.points[faces]:
            corners = [p.tobytes() for p in face]
            k = corners.index(min(corners))
            rows.append(b"".join(corners[k:] + corners[:k]))
    return sorted(rows)


def without(args, flags):
    """Arguments without some flags and their values."""
    gone = {i + k for i, a in enumerate(args) if a in flags for k in (0, 1)}
    return [a for i, a in enumerate(args) if i not in gone]


def ask_pieces(case, run, folder, is_complete):
    mesh = joined(os.path.join(folder, "out"))
    expect_sound(mesh, case, is_complete, "pieces")
    check_report(folder, mesh)
    if case.has_sag or (case.quads and mesh.counts()[1] < 3000):
        return mesh  # made in another way where it is in one piece
    args = without(case.args, ("--piece-count", "--across"))
    result = run(["mesh", case.main, "-o", "whole.obj", "--threads", "1", *args, *case.model_args,
                  "--across", "off"], folder)
    expect((0, 3), result, "mesh in one piece")
    whole = mesh_files.read_obj(os.path.join(folder, "whole.obj"))
    if face_keys(whole) != face_keys(mesh):
        raise Fault("pieces differ from the mesh in one piece")
    return mesh


# ---------------------------------------------------------------------------- formats
def sorted_points(mesh):
    return mesh.points[np.lexsort(mesh.points.T)]


def expect_equal(mesh, other, name):
    """Another format has the same faces; their order and numbers may differ."""
    (area, volume), (other_area, other_volume) = area_and_volume(mesh), area_and_volume(other)
    is_single = name.endswith(".stl")
    share = SINGLE if is_single else DOUBLE
    if not is_single:
        expect_same(f"vertices of {name}", other.counts()[0], mesh.counts()[0])
        expect_same(f"faces of {name}", other.counts()[1], mesh.counts()[1])
        if (sorted_points(mesh) != sorted_points(other)).any():
            raise Fault(f"{name} has other coordinates")
    expect_same(f"area of {name}", other_area, area, share)
    if abs(other_volume - volume) > share * max(abs(volume), area**1.5):
        raise Fault(f"volume of {name} {other_volume!r} not {volume!r}")


def written_only(path, mesh):
    """Counts of the formats that the program does not read."""
    triangles = sum((k - 2) * len(f) for k, f in mesh.faces.items())
    name = os.path.basename(path)
    if name.endswith(".glb"):
        return expect_same("triangles of .glb", mesh_files.glb_triangles(path), triangles)
    count = {"vtk": mesh_files.vtk_counts, "inp": mesh_files.inp_counts,
             "bdf": mesh_files.bdf_counts}[name.split(".")[-1]]
    found, wanted = count(path), mesh.counts()
    expect_same(f"vertices of {name}", found[0], wanted[0])
    expect_same(f"faces of {name}", found[1], wanted[1])
    return None


def ask_formats(case, run, folder, is_complete):
    """The .om file becomes every format, is checked as such, and comes back."""
    def convert(source, target, *more):
        expect((0,), run(["convert", source, target, *more], folder), f"convert {source} {target}")
        return os.path.join(folder, target)
    mesh = mesh_files.read_obj(convert("out.om", "out.obj"))
    expect_sound(mesh, case, is_complete, "mesh")
    check_report(folder, mesh)
    check_by_program(run, folder, "out.om", mesh, is_complete)
    if is_complete:
        check_by_program(run, folder, "out.om", None, True,
                         ["--model", case.main, *case.model_args])
    # Which version is no matter of chance, so that a case is always the same.
    version = VERSIONS[sum(mesh.counts()) % len(VERSIONS)]
    for ending in READABLE:
        name, back = f"copy.{ending}", f"back_{ending}.obj"
        convert("out.om", name, *(["--msh", version] if ending == "msh" else []))
        expect_equal(mesh, mesh_files.read_obj(convert(name, back)), name)
        if ending in mesh_files.READERS:
            own = mesh_files.READERS[ending](os.path.join(folder, name))
            expect_equal(mesh, own, name + " by our reader")
        if ending != "stl":
            check_by_program(run, folder, name, mesh, is_complete)
    for ending in WRITTEN_ONLY:
        written_only(convert("out.om", f"copy.{ending}"), mesh)
    return mesh


ASK = {"mesh": ask_mesh, "pieces": ask_pieces, "formats": ask_formats}
