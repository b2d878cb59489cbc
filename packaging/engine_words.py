#!/usr/bin/env python3
"""Lists what the engine tells, the patterns of core::Message (engine/core/message.hpp) in the code, for the translators.

Usage: engine_words.py list TO.cpp      writes them as lupdate reads them, in the context "Engine"
       engine_words.py check FILE.ts... says which of them a file of translations lacks
"""

import ast
import pathlib
import re
import sys
import xml.etree.ElementTree as xml

ROOT = pathlib.Path(__file__).parents[1]
# Of the command line and of Python, which speak English.
LEFT_OUT = (ROOT / "app/cli", ROOT / "app/python")

# What takes a pattern: the first of its arguments that is a literal.
CALL = re.compile(r"\b(?:message|InputError|GraphicsFault|fail|refuse|error|error_at|located_error|"
                  r"check_range_of|Pattern<0>)\(")
LITERAL = re.compile(r'"(?:[^"\\\n]|\\.)*"(?:\s*"(?:[^"\\\n]|\\.)*")*')
RAW = re.compile(r'R"\((.*?)\)"', re.DOTALL)
SKIPPED = re.compile(r"//[^\n]*|'(?:[^'\\]|\\.)'")


def pattern_from(code: str, at: int) -> str | None:
    """That of the call whose arguments begin at that place."""
    depth = 1
    while at < len(code) and depth > 0:
        raw, literal, skipped = RAW.match(code, at), LITERAL.match(code, at), SKIPPED.match(code, at)
        if depth == 1 and (raw or literal):
            return raw.group(1) if raw else ast.literal_eval(f"({literal.group(0)})")
        found = raw or literal or skipped
        depth += {"(": 1, ")": -1, "{": 1, "}": -1}.get(code[at], 0)
        at = found.end() if found else at + 1
    return None


def patterns() -> list[str]:
    found = set()
    for file in sorted([*ROOT.glob("engine/**/*.[ch]pp"), *ROOT.glob("app/**/*.[ch]pp")]):
        if any(file.is_relative_to(folder) for folder in LEFT_OUT):
            continue
        code = file.read_text()
        found |= {pattern_from(code, call.end()) for call in CALL.finditer(code)}
    return sorted(found - {None, ""})


def in_cpp(words: str) -> str:
    return '"' + words.replace("\\", "\\\\").replace('"', '\\"') + '"'


def translated(file: pathlib.Path) -> set[str]:
    return {message.findtext("source")
            for context in xml.parse(file).iterfind("context") if context.findtext("name") == "Engine"
            for message in context.iterfind("message")
            if message.find("translation").get("type") is None and message.findtext("translation")}


def check(files: list[str]) -> int:
    lacking = [f"{file}: not translated: {words}"
               for file in files for words in patterns() if words not in translated(pathlib.Path(file))]
    print("\n".join(lacking))
    return 1 if lacking else 0


def main() -> int:
    match sys.argv[1:]:
        case ["list", to]:
            pathlib.Path(to).write_text("".join(f'QT_TRANSLATE_NOOP("Engine", {in_cpp(words)})\n' for words in patterns()))
            return 0
        case ["check", *files] if files:
            return check(files)
    print(__doc__, file=sys.stderr)
    return 2


if __name__ == "__main__":
    sys.exit(main())
