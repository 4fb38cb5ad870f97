#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Mesh CAD files with surfmesh and with Gmsh at the same sizes, and compare shape and speed.

Sizes: 20 segments to a full turn, from 0.01 to 5 % of the diagonal, no stretch. Times are of the
processor, with one thread, without files: of surfmesh all stages but reading and writing, of Gmsh
its "meshing 2D" alone, without the curves. Quality is 4 √3 area / sum of squared sides. Both
programs run one after the other on each file.
"""
import argparse
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile

STAGES = ("control", "boundary", "triangulate", "refine", "improve", "quad", "assemble",
          "across")
SIZES = ["--segments-per-circle", "20", "--stretch", "1", "--hmin", "0.01%", "--hmax", "5%"]


def qualities(points, triangles):
    for triangle in triangles:
        a, b, c = (points[v] for v in triangle)
        u = [b[i] - a[i] for i in range(3)]
        v = [c[i] - a[i] for i in range(3)]
        w = [c[i] - b[i] for i in range(3)]
        cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
        sides = sum(x * x for edge in (u, v, w) for x in edge)
        yield 2 * math.sqrt(3) * math.sqrt(sum(x * x for x in cross)) / sides if sides else 0


def open_edges(triangles):
    counts = {}
    for triangle in triangles:
        for i in range(3):
            edge = tuple(sorted((triangle[i], triangle[(i + 1) % 3])))
            counts[edge] = counts.get(edge, 0) + 1
    return sum(1 for count in counts.values() if count == 1)


def read_off(path):
    words = path.read_text().split()
    points, faces = int(words[1]), int(words[2])
    values = [float(x) for x in words[4:4 + 3 * points]]
    corners = [int(x) for x in words[4 + 3 * points:]]
    return ([values[3 * i:3 * i + 3] for i in range(points)],
            [corners[4 * i + 1:4 * i + 4] for i in range(faces)])


def read_msh(path):
    lines = path.read_text().splitlines()
    start = lines.index("$Nodes") + 2
    points = {}
    for line in lines[start:lines.index("$EndNodes")]:
        words = line.split()
        points[int(words[0])] = [float(x) for x in words[1:]]
    start = lines.index("$Elements") + 2
    triangles = []
    for line in lines[start:lines.index("$EndElements")]:
        words = [int(x) for x in line.split()]
        if words[1] == 2:
            triangles.append(words[-3:])
    return points, triangles


def measure(points, triangles, seconds):
    quality = list(qualities(points, triangles))
    if not quality:
        return None
    return {"triangles": len(quality), "least": min(quality), "mean": sum(quality) / len(quality),
            "below": sum(1 for q in quality if q < 0.3) / len(quality),
            "open": open_edges(triangles), "seconds": seconds}


def run_surfmesh(program, file, folder):
    mesh, report = folder / "mesh.off", folder / "report.json"
    command = [program, "mesh", file, "-o", mesh, "--report", report, "--quiet", "--threads", "1"]
    result = subprocess.run([str(x) for x in command + SIZES], capture_output=True, text=True)
    if result.returncode not in (0, 3):
        return None, None, result.stderr.strip()
    read = json.loads(report.read_text())
    seconds = sum(s for stage, s in read["seconds"].items() if stage in STAGES)
    return measure(*read_off(mesh), seconds), read["diagonal"], result.stderr.strip()


def run_gmsh(file, diagonal, folder):
    mesh = folder / "mesh.msh"
    command = ["gmsh", "-2", file, "-algo", "front2d", "-nt", "1", "-format", "msh22", "-o", mesh,
               "-clcurv", "20", "-clmin", 1e-4 * diagonal, "-clmax", 0.05 * diagonal,
               "-string", 'Geometry.OCCTargetUnit="MM";']
    try:
        result = subprocess.run([str(x) for x in command], capture_output=True, text=True,
                                timeout=150)
    except subprocess.TimeoutExpired:
        return None
    found = re.search(r"Done meshing 2D \(Wall [\d.e-]+s, CPU ([\d.e-]+)s\)", result.stdout)
    if not found or not mesh.exists():
        return None
    measured = measure(*read_msh(mesh), float(found.group(1)))
    mesh.unlink()
    return measured


def text_of(measured):
    if not measured:
        return "fails"
    return (f"{measured['triangles']}, {measured['least']:.3f} / {measured['mean']:.3f}, "
            f"{100 * measured['below']:.2f} %, {measured['open']}, {measured['seconds']:.3f}")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", help="surfmesh")
    parser.add_argument("files", nargs="+", type=pathlib.Path)
    arguments = parser.parse_args()
    print("| file | surfmesh: triangles, least / mean quality, below 0.3, open edges, s | "
          "Gmsh: the same |\n|---|---|---|")
    sums = {"surfmesh": [0, 0.0], "gmsh": [0, 0.0]}
    worse, flat = [], []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for file in arguments.files:
            own, diagonal, said = run_surfmesh(arguments.program, file, folder)
            if not own:
                print(f"| {file.name} | fails: {said} | |")
                continue
            other = run_gmsh(file, diagonal, folder)
            print(f"| {file.name} | {text_of(own)} | {text_of(other)} |", flush=True)
            if own["below"] > 0.001:
                flat.append(file.name)
            if not other:
                continue
            if own["least"] < min(other["least"], 0.7):
                worse.append(file.name)
            for key, measured in (("surfmesh", own), ("gmsh", other)):
                sums[key][0] += measured["triangles"]
                sums[key][1] += measured["seconds"]
    rates = {key: count / max(seconds, 1e-9) for key, (count, seconds) in sums.items()}
    for key, (count, seconds) in sums.items():
        print(f"\n{key}: {count} triangles in {seconds:.2f} s, {rates[key]:.0f} a second")
    print(f"\nratio of triangles a second: {rates['surfmesh'] / max(rates['gmsh'], 1e-9):.2f}")
    print(f"\nleast quality below Gmsh's and 0.7: {', '.join(worse) or 'none'}")
    print(f"\nmore than 0.1 % below quality 0.3: {', '.join(flat) or 'none'}")


if __name__ == "__main__":
    sys.exit(main())
