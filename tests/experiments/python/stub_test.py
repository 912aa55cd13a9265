# SPDX-License-Identifier: BSD-3-Clause
"""The type stubs say what the module has: names, parameters in their order, defaults, members."""

import ast
import enum
import pathlib
import re
import unittest

import gmapping_spa as gs

FOLDER = pathlib.Path(gs.__file__).parent
TYPES_ONLY = {"BackEnd", "Path", "Loss", "Initialization", "Array", "Trajectory", "Nodes", "Edges"}


def stub():
    """Definitions by name."""
    definitions = {}
    for file in ("_slam_options.pyi", "__init__.pyi"):
        for item in ast.parse((FOLDER / file).read_text()).body:
            if isinstance(item, (ast.ClassDef, ast.FunctionDef)):
                definitions[item.name] = item
            elif isinstance(item, ast.AnnAssign):
                definitions[item.target.id] = item
    return {name: item for name, item in definitions.items() if name not in TYPES_ONLY}


def stub_parameters(function):
    """Names, "*" before those by keyword only; "=..." behind those with a default."""
    arguments = function.args
    count = len(arguments.args) - len(arguments.defaults)
    names = [a.arg + ("=" if k >= count else "") for k, a in enumerate(arguments.args)]
    names = [name for name in names if name != "self"]
    if arguments.kwonlyargs:
        names.append("*")
    names += [a.arg + ("=" if d else "") for a, d in zip(arguments.kwonlyargs, arguments.kw_defaults)]
    return names


def module_parameters(function):
    """The same, from the signature that pybind11 writes into the docstring."""
    signature = function.__doc__.splitlines()[0]
    inner = signature[signature.index("(") + 1 : signature.rindex(") ->")]
    names, depth, part = [], 0, ""
    for character in inner + ",":
        depth += (character in "([{") - (character in ")]}")
        if character == "," and depth == 0:
            name = re.match(r"\s*(\*?\w*)", part)[1]
            names.append(name + ("=" if re.search(r"(?<![=<>])=(?!=)", part) else ""))
            part = ""
        else:
            part += character
    return [name for name in names if name not in ("self", "self=", "")]


class StubTest(unittest.TestCase):
    def test_names_are_those_of_the_module(self):
        self.assertEqual(set(stub()) - {"__version__"}, set(gs.__all__))
        self.assertTrue((FOLDER / "py.typed").exists())

    def test_functions_have_their_parameters(self):
        for name, item in stub().items():
            if isinstance(item, ast.FunctionDef):
                self.assertEqual(stub_parameters(item), module_parameters(getattr(gs, name)), name)

    def test_classes_have_their_members(self):
        for name, item in stub().items():
            if not isinstance(item, ast.ClassDef):
                continue
            cls = getattr(gs, name)
            if issubclass(cls, enum.Enum):
                self.assertEqual([a.targets[0].id for a in item.body],
                                 [member.name for member in cls])
                continue
            members = {getattr(m, "name", None) or m.target.id: m for m in item.body}
            public = {m for m in vars(cls) if not m.startswith("_")}
            self.assertEqual({m for m in members if not m.startswith("_")}, public, name)
            for member, definition in members.items():
                self.assertTrue(hasattr(cls, member), f"{name}.{member}")
                is_property = isinstance(vars(cls).get(member), property)
                declared = isinstance(definition, ast.AnnAssign) or any(
                    getattr(d, "id", "") == "property" for d in definition.decorator_list)
                self.assertEqual(is_property, declared, f"{name}.{member}")
                if isinstance(definition, ast.FunctionDef) and not declared and name != "SlamOptions":
                    if not member.startswith("__") or member == "__init__":
                        self.assertEqual(stub_parameters(definition),
                                         module_parameters(getattr(cls, member)),
                                         f"{name}.{member}")

    def test_options_can_be_given_by_name(self):
        item = stub()["SlamOptions"]
        attributes = [a for a in item.body if isinstance(a, ast.AnnAssign)]
        init = next(f for f in item.body if getattr(f, "name", "") == "__init__")
        self.assertEqual([a.arg for a in init.args.kwonlyargs], [a.target.id for a in attributes])
        for argument, attribute in zip(init.args.kwonlyargs, attributes):
            self.assertEqual(ast.unparse(argument.annotation), ast.unparse(attribute.annotation))
            # The types are those of the defaults.
            value = getattr(gs.SlamOptions(), attribute.target.id)
            annotation = ast.unparse(attribute.annotation)
            if annotation in ("int", "float", "bool", "str"):
                self.assertEqual(type(value).__name__, annotation, attribute.target.id)
            elif annotation.startswith("Literal"):
                self.assertIn(value, ast.literal_eval(annotation.removeprefix("Literal")))

    def test_everything_says_what_it_is(self):
        for name in gs.__all__:
            item = getattr(gs, name)
            if callable(item):
                self.assertGreater(len(item.__doc__ or ""), 15, name)
            for member, value in vars(item).items() if isinstance(item, type) else ():
                if isinstance(value, property) and name != "SlamOptions":
                    self.assertTrue(value.__doc__ or name == "Statistics" or "Errors" in name,
                                    f"{name}.{member}")


if __name__ == "__main__":
    unittest.main()
