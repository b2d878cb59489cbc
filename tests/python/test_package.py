"""What pip is told of the package, and the archive that it installs."""

import base64
import email
import hashlib
import sys
import unittest
import zipfile

import pastoso
from command_line import SOURCE, InFolder

sys.path.insert(0, str(SOURCE / "packaging/python"))
import build_backend  # noqa: E402


class Package(InFolder):
    def test_is_of_the_programs_version(self):
        told = email.message_from_string(build_backend.metadata())
        self.assertEqual((told["Name"], told["Version"]), ("pastoso", pastoso.__version__))
        self.assertEqual(told.get_all("Requires-Dist"), ["numpy>=1.20"])
        self.assertIn("import pastoso", told.get_payload())

    def test_archive_lists_its_files(self):
        path = self.folder / "a.whl"
        files = {"pastoso/_engine.so": b"binary", "pastoso/__init__.py": b"text"}
        build_backend.write_wheel(path, files)
        with zipfile.ZipFile(path) as wheel:
            record = [line.split(",") for line in wheel.read(wheel.namelist()[-1]).decode().splitlines()]
            self.assertEqual({name for name, _, _ in record}, set(wheel.namelist()))
            for name, digest, size in record[:-1]:
                content = wheel.read(name)
                expected = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
                self.assertEqual((digest, int(size)), (f"sha256={expected}", len(content)))
        again = self.folder / "b.whl"
        build_backend.write_wheel(again, dict(reversed(files.items())))
        self.assertEqual(again.read_bytes(), path.read_bytes())


if __name__ == "__main__":
    unittest.main()
