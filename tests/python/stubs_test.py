# SPDX-License-Identifier: BSD-3-Clause
"""Names, docstrings and type hints of the package and of its stubs."""

import ast
import inspect
import os
import sys
import typing
import unittest

import support

import surfmesh
from surfmesh import _mesh, _model, _options, _run, _surfmesh

sys.path.insert(0, os.path.join(support.SOURCE, "tools", "python"))
import make_option_stub  # noqa: E402

PACKAGE = os.path.join(support.SOURCE, "tools", "python", "surfmesh")


def stub(name):
    with open(os.path.join(PACKAGE, name)) as file:
        return ast.parse(file.read())


def public(names):
    return {name for name in names if not name.startswith("_")}


class Stubs(unittest.TestCase):
    def test_have_the_names_of_the_extension(self):
        body = stub("_surfmesh.pyi").body
        found = {node.name for node in body if isinstance(node, (ast.FunctionDef, ast.ClassDef))}
        found |= {node.target.id for node in body if isinstance(node, ast.AnnAssign)}
        self.assertEqual(public(found), public(dir(_surfmesh)))

    def test_have_the_members_of_its_classes(self):
        for node in stub("_surfmesh.pyi").body:
            if not isinstance(node, ast.ClassDef):
                continue
            members = {part.name for part in node.body if isinstance(part, ast.FunctionDef)}
            self.assertEqual(public(members), public(dir(getattr(_surfmesh, node.name))), node.name)

    def test_have_the_parameters_of_the_runs(self):
        functions = {node.name: node for node in stub("_run.pyi").body
                     if isinstance(node, ast.FunctionDef)}
        expected = {name for name, entry in vars(_run).items() if inspect.isfunction(entry)
                    and entry.__module__ == "surfmesh._run" and not name.startswith("_")}
        self.assertEqual(set(functions), expected)
        for name, node in functions.items():
            written = [a.arg for a in node.args.args + node.args.kwonlyargs]
            written += [node.args.kwarg.arg] if node.args.kwarg else []
            self.assertEqual(written, list(inspect.signature(getattr(_run, name)).parameters))

    def test_of_options_are_made_from_the_table(self):
        with open(os.path.join(PACKAGE, "_options.pyi")) as file:
            self.assertEqual(file.read(), make_option_stub.stub())


class Names(unittest.TestCase):
    def classes(self):
        return [getattr(surfmesh, name) for name in surfmesh.__all__
                if inspect.isclass(getattr(surfmesh, name))]

    def functions(self):
        for name in surfmesh.__all__:
            entry = getattr(surfmesh, name)
            if inspect.isroutine(entry):
                yield entry
        for kind in (surfmesh.Mesh, surfmesh.Model):
            for name, entry in vars(kind).items():
                if name.startswith("_"):
                    continue
                yield getattr(entry, "fget", None) or getattr(entry, "func", entry)

    def test_are_all_listed(self):
        names = public(name for name, entry in vars(surfmesh).items()
                       if not inspect.ismodule(entry))
        self.assertEqual(names, set(surfmesh.__all__))

    def test_have_docstrings(self):
        for entry in self.classes():
            self.assertTrue(inspect.getdoc(entry), entry)
            for name in public(vars(entry)):
                member = getattr(entry, name)
                if callable(member) or isinstance(vars(entry)[name], property):
                    self.assertTrue(inspect.getdoc(vars(entry)[name]), f"{entry}.{name}")
        for entry in self.functions():
            self.assertTrue(inspect.getdoc(entry), entry)
        for name in public(dir(_surfmesh)):
            if callable(getattr(_surfmesh, name)):
                self.assertTrue(getattr(_surfmesh, name).__doc__, name)

    def test_have_type_hints(self):
        for entry in self.functions():
            if entry is surfmesh.formula_functions:
                continue
            signature = inspect.signature(entry)
            self.assertIsNot(signature.return_annotation, inspect.Signature.empty, entry)
            for parameter in signature.parameters.values():
                if parameter.name not in ("self", "cls"):
                    self.assertIsNot(parameter.annotation, inspect.Parameter.empty, entry)
            typing.get_type_hints(entry, {**vars(_run), **vars(_model), **vars(_mesh),
                                          **vars(_options)})

    def test_have_a_version(self):
        self.assertRegex(surfmesh.__version__, r"^\d+\.\d+\.\d+$")
        self.assertIn("sqrt", surfmesh.formula_functions())


if __name__ == "__main__":
    unittest.main()
