"""Makes the batch `samples`: samples of the sands of lower/sands.jsonl, what mdm verify says of each, and a certificate of that."""

import json
import pathlib
import tempfile
from decimal import Context, Decimal
from fractions import Fraction
from itertools import accumulate

from answers import mdm, write_table

COLUMNS = ("id,gradation,sample,options,verdict,particles,below,above,retained_error_lo,retained_error_hi,"
           "passing_error_lo,passing_error_hi,total_error_lo,total_error_hi").split(",")
WITHIN = "--tolerance retained:1%"
PUBLISHED = ("rounded", "fixed-size", "spanned-integer")
QUESTIONS = (("exact", ""), ("one-more", ""), ("one-less", ""), ("one-less", WITHIN), ("on-sieve", ""), ("outside", ""),
             ("six-digits", ""), ("six-digits", "--tolerance retained:0.01%"), ("ranges", "--tolerance retained:0.000000001%"),
             ("rounded", ""), ("fixed-size", "--tolerance total:1%"), ("spanned-integer", ""), ("fewer", ""), ("fewer", WITHIN),
             ("fewer", "--tolerance passing:0.5%"))


def canonical(gradation, answer, *options):
    """The sample of an answer of mdm solve, in the form that a certificate of it is about."""
    with tempfile.TemporaryDirectory() as work:
        mdm("verify", gradation, "-", *options, "--proof", f"{work}/proof", "--quiet", text=answer)
        return pathlib.Path(f"{work}/proof.sample.csv").read_text()


def published(algorithm, gradation):
    with tempfile.TemporaryDirectory() as work:
        mdm("published", algorithm, gradation, "--proof", f"{work}/proof", "--quiet")
        return pathlib.Path(f"{work}/proof.sample.csv").read_text()


def powers(rows):
    return "size_mm^3,quantity\n" + "".join(f"{z},{q}\n" for z, q in rows)


def with_quantity(rows, i, more):
    return powers([(z, q + more * (i == j)) for j, (z, q) in enumerate(rows) if q + more * (i == j)])


def samples(gradation):
    """The text of each sample of a sand."""
    answer = mdm("solve", gradation, "--format", "json", "--quiet")
    classes = [c for c in json.loads(answer)["classes"] if c["size"]]
    exact = canonical(gradation, answer)
    rows = [(Fraction(z), int(q)) for z, q in (line.split(",") for line in exact.splitlines()[1:])]
    finest = max(range(len(rows)), key=lambda i: rows[i][1])  # that of the most particles
    lower, upper = (Fraction(classes[-1][end]) ** 3 for end in ("lower", "upper"))
    six = Context(prec=6)
    fewer = mdm("solve", gradation, *WITHIN.split(), "--format", "json", "--quiet")
    return {
        "exact": exact,
        "one-more": with_quantity(rows, len(rows) - 1, 1),
        "one-less": with_quantity(rows, finest, -1),
        "on-sieve": powers([*rows[:-1], (lower, rows[-1][1])]),
        "outside": powers([*rows[:-1], (upper * (1 + Fraction(1, 10 ** 15)), rows[-1][1])]),
        "six-digits": "size_mm,quantity\n" + "".join(f"{six.create_decimal(Decimal(c['size'][0])).normalize():f},{c['quantity']}\n"
                                                     for c in classes),
        "ranges": "size_lo_mm,size_hi_mm,quantity\n" + "".join(f"{','.join(c['size'])},{c['quantity']}\n" for c in classes),
        "fewer": canonical(gradation, fewer, *WITHIN.split()),
        **{algorithm: published(algorithm, gradation) for algorithm in PUBLISHED}}


def errors(report, proof):
    """The two ends of each error, in percentage points: from the shares where they are exact, else from the certificate."""
    found = [c["found"] for c in report["classes"]]
    if any(isinstance(share, list) for share in found):
        return [end for line in proof.splitlines() if "-error" in line for end in line.split()[-2:]]
    off = [Fraction(share) - Fraction(c["target"]) for share, c in zip(found, report["classes"])]
    largest = (max(map(abs, off)), max(map(abs, list(accumulate(off))[:-1])), sum(map(abs, off)))
    return [100 * error for error in largest for _ in range(2)]


def row(sand, sample, options):
    """The answer to a question, and its certificate in a file."""
    name = f"{sand}-{sample}" + options.replace("--tolerance ", "-within-").replace(":", "-").replace("%", "")
    gradation, file, proof = f"samples/{sand}.csv", f"samples/{sand}-{sample}.csv", pathlib.Path(f"samples/{name}.proof")
    report = json.loads(mdm("verify", gradation, file, *options.split(), "--proof", proof, "--format", "json", "--quiet", codes=(0, 1)))
    return [name, f"{sand}.csv", f"{sand}-{sample}.csv", options, report["verdict"], report["particles"],
            *report["outside"].values(), *errors(report, proof.read_text())]


def make():
    rows = []
    for line in pathlib.Path("lower/sands.jsonl").read_text().splitlines():
        sand = json.loads(line)
        gradation = f"samples/{sand['id']}.csv"
        write_table(gradation, ["size_mm", "mass"], zip(sand["sizes"], sand["masses"]))
        for sample, text in samples(gradation).items():
            pathlib.Path(f"samples/{sand['id']}-{sample}.csv").write_text(text)
        rows += [row(sand["id"], sample, options) for sample, options in QUESTIONS]
    write_table("samples/samples.answers.csv", COLUMNS, rows)
