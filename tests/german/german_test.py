#!/usr/bin/python3
"""german_test.py SOURCE: src/text/german.json has what the programs say, and all that they note.

SOURCE is the top folder of the project. The English text of each row is in the sources, as a literal or a sum of some, and
its German text has its places. Each note that a source adds has a row, but for the exceptions.
"""

import json
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import templates as cpp

SOURCE = pathlib.Path(sys.argv[1]).resolve()
PLACE = re.compile(r"\{([\w#]*)\}")

# Rows that are no literal of a source, and why.
MADE = {
    "{}: {note}": "the name of a file, with a line or not, or of samples stands before",
    "{}: {note} (of the material {})": "the same, of one of several materials",
    ", UTF-16LE": "an encoding behind a format", ", UTF-16BE": "the same", ", Windows-1252 (Latin-1)": "the same",
    "size_mm, size_um, size_m, size_in, size_phi, sieve": "size_columns, a list of names",
    "1 field": "a row is said to have 1 field, or so many fields",
    "Whether one curve keeps all limits together is not decided: a sieve that they are about is no sieve of the sample, or two "
    "fineness moduli hang.": "sentence() in conformity.cpp makes a sentence of a reason",
}

# Files whose notes neither the page nor the report shows, and why.
ELSEWHERE = {
    "src/plot/": "a picture's own words, which picture_texts.cpp has in both languages",
    "src/papers/": "the papers' tables",
    "src/crosscheck/": "of mdm crosscheck",
    "src/cli/crosscheck": "of mdm crosscheck",
    "src/cli/plot.cpp": "of mdm plot",
    "src/cli/plot_gradation.cpp": "of mdm plot",
    "src/cli/batch_solver.cpp": "of mdm batch",
    "src/ask/generate.cpp": "of mdm generate",
    "src/ask/inverse.cpp": "of mdm generate --inverse",
    "src/ask/timesteps.cpp": "of mdm verify --over-time",
    "src/ask/export_space.cpp": "of mdm export, on standard error",
    "src/sets/": "of mdm generate",
    "src/report/published.cpp": "of mdm published",
    "src/files/sample_proof_files.cpp": "of mdm verify --proof",
    "src/python/": "of the Python module",
}

# Notes that are made elsewhere: this expression adds them.
HANDED_ON = {
    "*note", "note", "note,id", "text", "*std::move(note)", "std::move(note)", "problem.notes", "reader.notes()",
    "*settle_digits(table.values,reading.round,cumulative mass)", "rounding_note(result_.is_exact)", "rounding_note(curves_.box.is_exact)",
    "representative_note(match,*height)", "representative_note(d)", "left_out_note(all.interpolated)", "source_->size_note()",
    "source_.size_note()", "source.size_note()", "note.get<std::string>()", "note.is_string()?note.get<std::string>():note.dump()",
    "sentence(within.why().reason)", "read_sample_file(c.sample,options,verifier.sizes(),c.output.quiet)",
}

# Notes that stay English, and why.
ENGLISH = {
    "The places were not judged: {}.": "an error's own words stand in it",
    "The places were not judged: one {}.": "what is odd of a place stands in it",
    "{} is not written: there is nothing to write": "of mdm blend with files that the page does not ask for",
}

# Functions that make notes for others to add.
MAKERS = ("float_dust_note", "settle_digits", "rounding_note", "representative_note", "crowding_note", "left_out_note",
          "unit_note", "size_note", "note_on_other_sheets")


def skeleton(text):
    return PLACE.sub("{}", text)


def without_outer_places(text):
    return re.sub(r"^(\{\})+|(\{\})+$", "", text)


def sources():
    for path in sorted((SOURCE / "src").rglob("*.[ch]pp")) + sorted((SOURCE / "include").rglob("*.hpp")):
        name = path.relative_to(SOURCE).as_posix()
        if not name.startswith("src/checker/"):
            yield name, path.read_text(encoding="utf-8")


def spelled(items):
    """Tokens as they stand, without spaces."""
    return "".join(item if isinstance(item, str) else spelled(item) + cpp.CLOSING[item[0]] for item in items)


def made_by(argument):
    """The templates that an expression may be; none where it has no literal of its own."""
    found = []
    for part in cpp.split(argument, {"?", ":", ","}):
        template = cpp.template_of(part)
        if template is None and len(part) == 4 and spelled(part[:3]) == "fmt::format":
            template = cpp.template_of(cpp.split(part[3][1:], {","})[0])
        if template is not None:
            found.append(template)
    return found


def notes_in(items):
    """Each expression whose value becomes a note, as tokens."""
    for i, item in enumerate(items):
        if not isinstance(item, list):
            continue
        yield from notes_in(item)
        before = [one if isinstance(one, str) else "()" for one in items[max(0, i - 4):i]]
        call = before[-1] if before else ""
        adds = call in ("push_back", "emplace_back") and len(before) > 2 and before[-3] in ("notes", "notes_")
        says = call == "add_note" and before[-2:-1] != ["void"] or call == "note" and before[-2:-1] in (["."], ["->"])
        if item[0] == "(" and (adds or says):
            yield item[1:]
        if item[0] == "{" and len(item) > 1 and before[-2:] == ["notes", "="]:
            yield item[1:]
        if item[0] == "(" and before[-3:] == ["notes", ".", "back"] and items[i + 1:i + 2] == ["+="]:
            yield items[i + 2:items.index(";", i)]


def bodies(items, names):
    """The body of each function with one of these names."""
    for i, item in enumerate(items):
        if isinstance(item, list):
            yield from bodies(item, names)
            if item[0] == "{":
                head = [one for one in items[max(0, i - 3):i] if one != "const"]
                if len(head) > 1 and isinstance(head[-1], list) and head[-2] in names:
                    yield head[-2], item[1:]


def check_reader():
    """The test finds what it is about, and that alone."""
    source = '// notes.push_back("no")\nx.notes.push_back("a " "b" + c(d, "e") + "f");notes_.emplace_back(fmt::format("{:.3} g{}", h, "i"));' \
        'notes.push_back(a ? "j" : b + "k");t.notes = {fmt::format("l")};t.notes.back() += m("n", 1);others.push_back("o");s.note("p");'
    found = [made_by(note) for note in notes_in(cpp.tree(cpp.tokens(source)))]
    assert found == [["a b{}f"], ["{} g{}"], ["j", "{}k"], ["l"], [], ["p"]], found
    assert "{} g{}" in cpp.templates(source) and "e" in cpp.templates(source)
    (name, body), = bodies(cpp.tree(cpp.tokens('std::string T::rounding_note(bool b) const { return "q"; }')), MAKERS)
    assert name == "rounding_note" and list(cpp.templates_in(body)) == ["q"]


def check_rows(table):
    """Each row by itself."""
    for group, rows in table.items():
        seen = {}
        for english, german in rows:
            places, others = PLACE.findall(english), PLACE.findall(german)
            numbers = [str(i) for i in range(len(places))]
            if places != others and sorted(others) != numbers:
                yield f"{group}: {english}: other places: {german}"
            if re.search(r"[{}]", PLACE.sub("", english + german)) or ')t"' in english + german:
                yield f"{group}: {english}: a brace that is no place"
            if len(places) > 10 or not english.isascii():
                yield f"{group}: {english}: more than ten places, or letters beyond ASCII"
            if seen.setdefault(english, german) is not german:
                yield f"{group}: {english}: twice"
            yield from (f"{group}: {english}: no group {place}" for place in places
                        if place not in ("", "#", "note") and place not in table)
    used = {place for rows in table.values() for english, _ in rows for place in PLACE.findall(english)}
    yield from (f"no place of the group {group}" for group in table if group != "note" and group not in used)


def check_sources(table, found):
    """Each row is in the sources."""
    outer = {without_outer_places(template) for template in found}
    for group, rows in table.items():
        for english, _ in rows:
            text = without_outer_places(skeleton(english))
            if english not in MADE and re.search("[A-Za-z]{2}", text) and text not in outer:
                yield f"{group}: {english}: no source has this"


def check_notes(table):
    """Each note has a row."""
    used, elsewhere = set(), set()
    known = {without_outer_places(skeleton(english)) for rows in table.values() for english, _ in rows}

    def is_known(template):
        used.add(template)
        return template in ENGLISH or without_outer_places(template) in known

    for name, source in sources():
        items = cpp.tree(cpp.tokens(source))
        prefix = next((prefix for prefix in ELSEWHERE if name.startswith(prefix)), None)
        for note in notes_in(items):
            if prefix:
                elsewhere.add(prefix)
                continue
            made = made_by(note)
            if not made:
                used.add(spelled(note))
                if spelled(note) not in HANDED_ON:
                    yield f"{name}: {spelled(note)}: which note is this?"
            yield from (f"{name}: {template}: no German text" for template in made if not is_known(template))
        for maker, body in bodies(items, MAKERS):
            used.add(maker)
            yield from (f"{name}: {maker}: {template}: no German text" for template in cpp.templates_in(body)
                        if len(template) > 30 and not is_known(template))
    yield from (f"no exception any more: {one}" for one in [*HANDED_ON, *ENGLISH, *MAKERS] if one not in used)
    yield from (f"no notes any more: {one}" for one in ELSEWHERE if one not in elsewhere)


def main():
    check_reader()
    table = json.loads((SOURCE / "src/text/german.json").read_text(encoding="utf-8"))
    found = {template for _, source in sources() for template in cpp.templates(source)}
    failures = [*check_rows(table), *check_sources(table, found), *check_notes(table)]
    count = sum(len(rows) for rows in table.values())
    print(f"{count} rows, {len(failures)} failures", *failures, sep="\n")
    return 1 if failures or count < 200 else 0


sys.exit(main())
