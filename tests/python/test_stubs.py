"""Type stubs and documentation that cannot lag behind what they tell of."""

import ast
import inspect
import unittest
from pathlib import Path

import pastoso
from pastoso import _engine

STUB = Path(pastoso.__file__).parent / "_engine.pyi"
CLASSES = ("Film", "Painting", "Tank", "Tea")


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


class Stubs(unittest.TestCase):
    def test_name_all_that_there_is(self):
        names, classes = stub_of(STUB)
        there = public(vars(_engine))
        self.assertEqual({name for name in there if not inspect.isclass(getattr(_engine, name))}, names)
        for name in CLASSES:
            self.assertEqual(public(vars(getattr(_engine, name))), classes[name], name)

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

    def test_names_units_of_what_it_reads(self):
        for thing in (pastoso.Film, pastoso.Painting):
            for field in ("thickness", "surface", "support"):
                self.assertIn("mm", inspect.getdoc(getattr(thing, field)))
                self.assertIn("(height, width)", inspect.getdoc(getattr(thing, field)))


if __name__ == "__main__":
    unittest.main()
