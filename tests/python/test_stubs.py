"""Type stubs and documentation that cannot lag behind what they tell of."""

import ast
import inspect
import re
import unittest
from pathlib import Path

import pastoso
from pastoso import _engine

STUB = Path(pastoso.__file__).parent / "_engine.pyi"
CLASSES = ("Film", "Painting", "Tank", "Tea")
# How stubs and package name what is or holds an array.
ARRAY = re.compile(r"NDArray|Floats|MeshArrays|ndarray|Mesh")
SHAPE = re.compile(r"\((count|cells|height|triangles|vertices|z)\b[^)]*\)")
UNIT = re.compile(r"\b(m|m/s|mm|mm/s|unit|share|sRGB|linear light)\b", re.IGNORECASE)


def public(names):
    return {name for name in names if not name.startswith("_")}


def stub_of(path):
    """Names of the stub, and of each of its classes the names within."""
    tree = ast.parse(path.read_text())
    functions = {node.name for node in tree.body if isinstance(node, ast.FunctionDef)}
    values = {node.target.id for node in tree.body if isinstance(node, ast.AnnAssign)}
    classes = {node.name: public(item.name for item in node.body if isinstance(item, ast.FunctionDef))
               for node in tree.body if isinstance(node, ast.ClassDef)}
    return functions | values, classes


def keys_of_dictionaries(path):
    """The keys of each TypedDict of the stub."""
    return {node.name: {item.target.id for item in node.body}
            for node in ast.parse(path.read_text()).body
            if isinstance(node, ast.ClassDef) and any(getattr(base, "id", "") == "TypedDict" for base in node.bases)}


def methods_that_return_arrays():
    """Names "Film.read", of methods and properties, as the package's sources annotate them."""
    for path in (STUB, *sorted(STUB.parent.glob("*.py"))):
        for node in ast.parse(path.read_text()).body:
            if not isinstance(node, ast.ClassDef) or node.name not in CLASSES:
                continue
            for item in node.body:
                if isinstance(item, ast.FunctionDef) and item.returns and ARRAY.search(ast.unparse(item.returns)):
                    yield node.name, item.name


class Stubs(unittest.TestCase):
    def test_name_all_that_there_is(self):
        names, classes = stub_of(STUB)
        there = public(vars(_engine))
        self.assertEqual({name for name in there if not inspect.isclass(getattr(_engine, name))}, names)
        for name in CLASSES:
            self.assertEqual(public(vars(getattr(_engine, name))), classes[name], name)

    def test_name_all_keys_of_dictionaries(self):
        shown = {"Layer": pastoso.Painting(10, 10, 1, "panel").layers()[0],
                 "Pigment": pastoso.pigments()["PB29"],
                 "ValidationCase": pastoso.validation_cases()["nusselt-film"],
                 "ValidationRow": pastoso.validate("nusselt-film", scheme="explicit")[0]}
        self.assertEqual({name: set(entry) for name, entry in shown.items()}, keys_of_dictionaries(STUB))

    def test_are_there_for_type_checkers(self):
        self.assertTrue((STUB.parent / "py.typed").exists())


class Documentation(unittest.TestCase):
    def test_is_on_everything(self):
        for name in pastoso.__all__:
            thing = getattr(pastoso, name)
            self.assertTrue(inspect.getdoc(thing), name)
            if name not in CLASSES:
                continue
            for method in public(dir(thing)):
                self.assertTrue(inspect.getdoc(getattr(thing, method)), f"{name}.{method}")

    def test_names_shapes_and_units_of_arrays(self):
        methods = set(methods_that_return_arrays())
        # One of each way in which they are annotated.
        self.assertLessEqual({("Film", "thickness"), ("Painting", "render"), ("Tea", "cup"), ("Tea", "cup_arrays"),
                              ("Tank", "read"), ("Tank", "surface")}, methods)
        for owner, name in sorted(methods):
            text = inspect.getdoc(getattr(getattr(pastoso, owner), name))
            self.assertRegex(text, SHAPE, f"{owner}.{name}")
            self.assertRegex(text, UNIT, f"{owner}.{name}")
        for words in ("m, float32 (vertices, 3)", "uint32 (triangles, 3)"):
            self.assertIn(words, inspect.getdoc(pastoso.Mesh))

    def test_names_units_of_what_it_reads(self):
        for thing in (pastoso.Film, pastoso.Painting):
            for field in ("thickness", "surface", "support"):
                self.assertIn("mm", inspect.getdoc(getattr(thing, field)))
                self.assertIn("(height, width)", inspect.getdoc(getattr(thing, field)))


if __name__ == "__main__":
    unittest.main()
