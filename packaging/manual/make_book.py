#!/usr/bin/env python3
"""Makes the manual of one language to be read without the program: a page of HTML for each of its pages, and a book in PDF.

    make_book.py MANUAL LANGUAGE OUT

MANUAL is the folder that the window reads (share/pastoso/manual): README.md in MANUAL/en lists the pages in their order. What
is not there in LANGUAGE is taken in English. Writes OUT/LANGUAGE/*.html, the pictures that they show into OUT/pictures, and
OUT/pastoso-LANGUAGE.pdf. A link to nothing is an error.
"""

import re
import shutil
import sys
import tempfile
from pathlib import Path

import markdown
import weasyprint
from markdown.extensions.toc import TocExtension
from PIL import Image

STYLE = """
body { font: 16px/1.5 "DejaVu Sans", "Noto Sans CJK JP", "Noto Sans CJK TC", sans-serif; color: #222; background: #fff;
       max-width: 46em; margin: 0 auto; padding: 1em 1.5em 4em; }
h1, h2 { line-height: 1.2; }
img { max-width: 100%; height: auto; }
code { background: #eee; border-radius: 3px; padding: 0 .25em; }
table { border-collapse: collapse; }
td:last-child { width: 45%; }
th, td { border-bottom: 1px solid #ccc; padding: .3em .8em .3em 0; text-align: left; vertical-align: top; }
nav { border-bottom: 1px solid #ccc; margin-bottom: 2em; padding-bottom: .5em; }
nav a { margin-right: 1em; white-space: nowrap; }
@page { size: A4; margin: 20mm 18mm; @bottom-center { content: counter(page); font-size: 9pt; } }
@media print { body { font-size: 10pt; max-width: none; padding: 0; } article { break-before: page; } }
"""

# Pictures in a book are named by what they are found under, which the folder that it was made in is no part of.
PRINTED = "printed:"


def anchor_of(heading, separator):
    """As links in the manual name a heading (help::anchor_of)."""
    return re.sub(r"[^\w -]", "", heading.lower()).replace(" ", separator)


class Manual:
    def __init__(self, folder, language):
        self.folder, self.language = folder, language
        contents = (folder / "en" / "README.md").read_text(encoding="utf-8")
        self.names = list(dict.fromkeys(["README"] + re.findall(r"^\d+\. \[[^\]]*\]\(([a-z-]+)\.md", contents, re.M)))

    def text(self, name):
        translated = self.folder / self.language / f"{name}.md"
        return (translated if translated.exists() else self.folder / "en" / f"{name}.md").read_text(encoding="utf-8")

    def headings(self, text):
        """Of its levels 1 to 6, those within code left out."""
        return re.findall(r"^#{1,6} (.*)$", re.sub(r"```.*?```", "", text, flags=re.S), flags=re.M)

    def anchors(self, name):
        """Translated headings are named by the English ones, in whose order they stand."""
        english = (self.folder / "en" / f"{name}.md").read_text(encoding="utf-8")
        return [anchor_of(heading, "-") for heading in self.headings(english)]

    def html(self, name):
        anchors = iter(self.anchors(name))
        names = TocExtension(slugify=lambda heading, separator: next(anchors, anchor_of(heading, separator)))
        return markdown.markdown(self.text(name), extensions=["tables", "fenced_code", "sane_lists", names])

    def title(self, name):
        return self.headings(self.text(name))[0]


def linked(html, target_of):
    """With other targets of its links and pictures: target_of(kind, target)."""
    return re.sub(r'(href|src)="([^"]*)"', lambda m: f'{m[1]}="{target_of(m[1], m[2])}"', html)


def document(language, title, body):
    return (f'<!DOCTYPE html>\n<html lang="{language.replace("_", "-")}">\n<head>\n<meta charset="utf-8">\n'
            f'<meta name="viewport" content="width=device-width">\n<title>{title}</title>\n<style>{STYLE}</style>\n</head>\n'
            f"<body>\n{body}\n</body>\n</html>\n")


def check(manual, name, target):
    """That a link within the manual, or to what stands beside it, leads somewhere."""
    path, _, anchor = target.partition("#")
    page = path.removesuffix(".md") or name
    if page in manual.names:
        if anchor and anchor not in manual.anchors(page):
            sys.exit(f"{name}.md: there is no #{anchor} in {page}.md.")
    elif not (manual.folder / "en" / path).resolve().exists() and not (manual.folder / path.removeprefix("../")).exists():
        sys.exit(f"{name}.md: there is no {path}.")


def write_pages(manual, out):
    """In folders that lie where those of the sources do: what the pages link to beside the manual is two folders up."""
    def target(name):
        def of(kind, to):
            if ":" in to:
                return to
            if kind == "src":
                return f"../{to}"
            check(manual, name, to)
            page = to.partition("#")[0].removesuffix(".md") or name
            return to.replace(".md", ".html", 1) if page in manual.names else f"../{to}"
        return of

    (out / manual.language).mkdir(parents=True, exist_ok=True)
    links = "".join(f'<a href="{name}.html">{manual.title(name)}</a>\n' for name in manual.names)
    for name in manual.names:
        body = f"<nav>\n{links}</nav>\n{linked(manual.html(name), target(name))}"
        file = out / manual.language / f"{name}.html"
        file.write_text(document(manual.language, manual.title(name), body), encoding="utf-8")


def printed(picture, folder):
    """A copy in the folder as fine as paper shows it."""
    copy = folder / f"{'-'.join(picture.parts[-2:])}.jpg"
    if not copy.exists():
        with Image.open(picture) as image:
            image.thumbnail((1200, 1200), Image.Resampling.LANCZOS)
            image.convert("RGB").save(copy, quality=88)
    return copy


def opened(url, folder):
    """What weasyprint asks for: nothing but printed pictures."""
    return {"string": (folder / url.removeprefix(PRINTED)).read_bytes(), "mime_type": "image/jpeg"}


def write_book(manual, out, scratch):
    def target(name):
        def of(kind, to):
            if kind == "src":
                return PRINTED + printed((manual.folder / "en" / to).resolve(), scratch).name
            if ":" in to:
                return to
            path, _, anchor = to.partition("#")
            page = path.removesuffix(".md") or name
            return f"#{page}-{anchor}" if anchor else f"#{page}"
        return of

    articles = []
    for name in manual.names:
        html = re.sub(r'<h(\d) id="', rf'<h\1 id="{name}-', linked(manual.html(name), target(name)))
        articles.append(f'<article id="{name}">{html}</article>')
    book = document(manual.language, "Pastoso", "\n".join(articles))
    weasyprint.HTML(string=book, url_fetcher=lambda url: opened(url, scratch)).write_pdf(out / f"pastoso-{manual.language}.pdf", optimize_size=("fonts",))


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    manual, out = Manual(Path(sys.argv[1]), sys.argv[2]), Path(sys.argv[3])
    write_pages(manual, out)
    shutil.copytree((manual.folder / "en" / "pictures").resolve(), out / "pictures", dirs_exist_ok=True)
    with tempfile.TemporaryDirectory() as scratch:
        write_book(manual, out, Path(scratch))


main()
