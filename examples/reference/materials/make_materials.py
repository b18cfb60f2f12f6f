"""Makes the answers to materials.csv, and their certificates."""

import csv
import json
from fractions import Fraction

from answers import mdm, write_table


def classes(question):
    """The rows of an answer, one a class; classes are numbered as in the certificate, where the last sieve of a material counts."""
    answer = json.loads(mdm("solve", f"materials/{question['gradation']}", *question["options"].split(), "--format", "json",
                            "--proof", f"materials/{question['id']}.proof", "--quiet"))
    found, names = answer["classes"], []
    whole = sum(Fraction(c["mass"]) for c in found)
    shares = answer.get("achieved") or [Fraction(c["mass"]) / whole for c in found]
    for number, (c, share) in enumerate(zip(found, shares)):
        names += [] if c["material"] in names else [c["material"]]
        yield [question["id"], answer["particles"], number + len(names), c["material"], c["lower"], c["upper"], share, c["quantity"],
               *(c["size"] or ("", ""))]


def make():
    with open("materials/materials.csv", encoding="utf-8") as table:
        rows = [row for question in csv.DictReader(table) for row in classes(question)]
    write_table("materials/materials.answers.csv",
                ["id", "particles", "class", "material", "lower", "upper", "share", "quantity", "size_lo", "size_hi"], rows)
