#!/usr/bin/python3
"""site_test.py MDM SOURCE BUILD: makes the site, as the target `site` does, without a warning; and it is whole.

Each link within it leads somewhere, and nothing is loaded from elsewhere; each command has a page with all of its
options; the gallery has each picture of the examples; the search knows each page; codespell finds no mistake.
"""
import html.parser
import json
import os
import pathlib
import re
import subprocess
import sys
import urllib.parse

MDM, SOURCE, BUILD = sys.argv[1], *(pathlib.Path(name).resolve() for name in sys.argv[2:])
HTML, PAGES = BUILD / "site/html", BUILD / "site/pages"


class Page(html.parser.HTMLParser):
    """The ids of a page, where it leads, what it loads, and its text."""

    def __init__(self, path):
        super().__init__()
        self.ids, self.links, self.loaded, self.words = set(), [], [], []
        self.feed(path.read_text(encoding="utf-8"))
        self.text = " ".join(self.words)

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        self.ids |= {values[name] for name in ("id", "name") if values.get(name)}
        (self.links if tag == "a" else self.loaded).extend(values[name] for name in ("href", "src") if values.get(name))

    def handle_data(self, data):
        self.words.append(data)


def broken_links(pages):
    for path, page in pages.items():
        name = path.relative_to(HTML)
        for link in page.links + page.loaded:
            parts = urllib.parse.urlsplit(link)
            if parts.netloc and link in page.loaded:
                yield f"{name} loads {link}"
            if parts.scheme or parts.netloc:
                continue
            place, part = urllib.parse.unquote(parts.path), urllib.parse.unquote(parts.fragment)
            target = pathlib.Path(os.path.normpath(path.parent / place)) if place else path
            if not target.is_file() or not target.is_relative_to(HTML):
                yield f"{name}: {link} leads nowhere"
            elif part and target in pages and part not in pages[target].ids:
                yield f"{name}: {link} has no such place"


def missing_options(pages):
    def help_of(*command):
        return subprocess.run([MDM, *command, "--help"], check=True, capture_output=True, text=True).stdout

    commands = re.findall(r"^  ([a-z]+) ", help_of().split("Subcommands:")[1].split("\n\n")[0], re.MULTILINE)
    assert len(commands) > 10, commands
    for command in commands:
        page = pages.get(HTML / f"commands/mdm-{command}.html")
        options = re.findall(r"^ +(?:-\w,)?(--[a-z0-9-]+)", help_of(command), re.MULTILINE)
        assert options, command
        shown = set(re.findall(r"--[a-z0-9-]+", page.text)) if page else set()
        yield from (f"mdm {command}: its page has no {option}" for option in options if option not in shown)


def missing_pictures():
    """Of the gallery; and those of which it says that tests draw them again."""
    text = (PAGES / "gallery.md").read_text(encoding="utf-8")
    for ending in ("png", "svg"):
        for path in SOURCE.glob(f"examples/**/*.{ending}"):
            if f"]({path.relative_to(SOURCE)})" not in text:
                yield f"the gallery has no {path.relative_to(SOURCE)}"
    again = text.partition("Tests draw these again")[2].partition("no test does")[0]
    drawn = {"examples/09-settled/settled.svg", *(str(path.relative_to(SOURCE))
                                                  for path in SOURCE.glob("src/packing/diagrams/*.svg"))}
    shown = set(re.findall(r"!\[[^]]*\]\(([^)]+)\)", again))
    yield from (f"a test draws {name} again, or the gallery says so: not both" for name in shown ^ drawn)


def not_searched():
    index = (HTML / "searchindex.js").read_text(encoding="utf-8")
    known = set(json.loads(index.removeprefix("Search.setIndex(").removesuffix(")"))["docnames"])
    return (f"the search does not know {path.relative_to(PAGES)}" for path in PAGES.rglob("*")
            if path.suffix in (".md", ".rst") and path.relative_to(PAGES).with_suffix("").as_posix() not in known)


def misspelled():
    """In the pages, and in what the reference of the Python module is made of."""
    files = [path for path in PAGES.rglob("*") if path.suffix in (".md", ".rst")]
    files += SOURCE.glob("src/python/exactmdm/*.py")
    codespell = ["codespell", "--ignore-words", pathlib.Path(__file__).with_name("accepted_words"), *files]
    return subprocess.run(codespell, capture_output=True, text=True).stdout.splitlines()


subprocess.run([SOURCE / "src/site/make_site", MDM, SOURCE, BUILD], check=True)
made = {path: Page(path) for path in HTML.rglob("*.html") if path != HTML / "exactmdm.html"}
failures = [*broken_links(made), *missing_options(made), *missing_pictures(), *not_searched(), *misspelled()]
print(*failures, f"{len(made)} pages, {len(failures)} failures", sep="\n")
sys.exit(1 if failures else 0)
