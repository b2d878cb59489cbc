"""The program that the package has to agree with."""

import json
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

import pastoso

SOURCE = Path(os.environ["PASTOSO_SOURCE"])


def run(*arguments):
    """Runs pastoso-cli, and returns its figures where --stats is among what follows."""
    words = [os.environ["PASTOSO_CLI"], *map(str, arguments)]
    return subprocess.run(words, check=False, capture_output=True, text=True)


class InFolder(unittest.TestCase):
    """Tests that leave files in a folder of their own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def figures(self, *arguments):
        """What --stats tells of a run that succeeds."""
        file = self.folder / "stats.json"
        result = run(*arguments, "--stats", file, "-q")
        self.assertEqual(result.returncode, 0, result.stderr)
        return json.loads(file.read_text())

    def sentence(self, *arguments):
        """What is complained of in a run that fails."""
        result = run(*arguments)
        self.assertEqual(result.returncode, 1, result.stderr)
        return result.stderr.removeprefix("pastoso-cli: ").strip()

    def input_error(self, work):
        with self.assertRaises(pastoso.InputError) as caught:
            work()
        return str(caught.exception)
