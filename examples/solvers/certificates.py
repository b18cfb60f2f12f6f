"""The certificates of answers: that they match, or with which errors they do not; mdm-check is asked about each."""

import json
import math
import os
import pathlib
import subprocess


def program(name):
    return str(pathlib.Path(os.environ["MDM_BIN"], name)) if "MDM_BIN" in os.environ else name


def near_sizes(gradation, quantities):
    """Sizes for counts that are no match: of a scale between those that classes ask for, each moved into its class."""
    sizes, masses = ([float(text) for text in gradation[key]] for key in ("sizes", "masses"))
    rows = sorted(zip(sizes, masses))
    classes = [(lower, upper, mass) for (lower, mass), (upper, _) in zip(rows, rows[1:])]
    if len(quantities) != len(classes):  # one a class with mass
        classes = [row for row in classes if row[2]]
    classes = [(*row, int(q)) for row, q in zip(classes, quantities)]
    held = [(q * lower**3 / mass, q * upper**3 / mass) for lower, upper, mass, q in classes if q and mass]
    scale = math.sqrt(max(least for least, _ in held) * min(most for _, most in held)) if held else 1
    return [repr(min(max((scale * mass / q) ** (1 / 3), lower + (upper - lower) / 1000), upper)) if q else None
            for lower, upper, mass, q in classes]


def add_errors(place, options, rows):
    """Counts for which there are no sizes have no certificate. With some that are near they are a sample, and the
    folder `errors` gets the certificates that it does not match."""
    wrong = [row for number, row in enumerate(rows, 1)
             if row["verdict"] == "not-a-match" and not (place / f"proofs/{number}.proof").exists()]
    if not wrong:
        return
    (place / "wrong.jsonl").write_text("".join(json.dumps(row["gradation"]) + "\n" for row in wrong))
    (place / "sized.jsonl").write_text("".join(json.dumps({
        "id": row["id"], "quantities": row["quantities"], "sizes": near_sizes(row["gradation"], row["quantities"]),
        "unit": row["gradation"].get("unit", "mm")}) + "\n" for row in wrong))
    words = ["crosscheck", "wrong.jsonl", "sized.jsonl", "--proofs", "errors", "--quiet", *options.split()]
    subprocess.run([program("mdm"), *words], cwd=place, stdout=subprocess.DEVNULL)


def check(place, options, rows):
    """How many certificates there are of a solver's answers in a folder, and of how many mdm-check says the same."""
    add_errors(place, options, rows)
    is_wrong = [row["verdict"] == "not-a-match" for row in rows]
    proofs = [(proof, True) for proof in sorted(place.glob("errors/*.proof"))]
    proofs += [(proof, is_wrong[int(proof.stem) - 1]) for proof in sorted(place.glob("proofs/*.proof"))]
    accepted = 0
    for proof, says_so in proofs:
        files = [proof.with_suffix(".gradation.json"), proof.with_suffix(".sample.csv"), proof]
        done = subprocess.run([program("mdm-check"), *files], stdout=subprocess.PIPE, text=True)
        accepted += done.returncode == 0 and (" not match " in done.stdout) == says_so
    return len(proofs), accepted
