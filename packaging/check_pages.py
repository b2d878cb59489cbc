#!/usr/bin/env python3
"""Checks pages as they are installed: that what they link to and show is there, and that books in PDF are such.

Usage: check_pages.py FOLDER
Reads all *.html and *.pdf below FOLDER, which must hold some of both. Tells each fault in a line; status 1 if there is one.
"""

import functools
import re
import sys
import urllib.parse
from pathlib import Path

LINK = re.compile(r'(?:href|src)="([^"]*)"')
NAME = re.compile(r'id="([^"]*)"')


@functools.cache
def names_in(page):
    return set(NAME.findall(page.read_text(encoding="utf-8")))


def faults_of_page(page):
    for link in sorted(set(LINK.findall(page.read_text(encoding="utf-8")))):
        address = urllib.parse.urlsplit(link)
        if address.scheme:
            continue
        target = page.parent / urllib.parse.unquote(address.path) if address.path else page
        anchor = urllib.parse.unquote(address.fragment)
        if not target.is_file():
            yield f"{page}: there is no {link}."
        elif anchor and target.suffix == ".html" and anchor not in names_in(target):
            yield f"{page}: {link} names a place that is not in {target.name}."


def faults_of_book(book):
    if not book.read_bytes().startswith(b"%PDF-"):
        yield f"{book}: is no PDF."


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    pages, books = (sorted(Path(sys.argv[1]).rglob(f"*.{ending}")) for ending in ("html", "pdf"))
    if not pages or not books:
        sys.exit(f"{sys.argv[1]}: holds {len(pages)} pages and {len(books)} books; there should be some of both.")
    faults = [fault for page in pages for fault in faults_of_page(page)]
    faults += [fault for book in books for fault in faults_of_book(book)]
    print("\n".join(faults + [f"{len(pages)} pages and {len(books)} books; {len(faults)} faults"]))
    sys.exit(1 if faults else 0)


main()
