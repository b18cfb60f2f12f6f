"""A problem of blends, a line of JSON as `mdm blend --problems` takes it, as the files that mdm-check reads, and what the
certificate of an answer has to say."""

from fractions import Fraction

MODULI = {"FM": ("astm", 11), "FM-EN": ("en", 6)}


def limited(problem):
    """The limits of fineness moduli that there are, by name."""
    return {modulus["name"]: (modulus.get("least", "0"), modulus.get("most", str(MODULI[modulus["name"]][1])))
            for modulus in problem.get("moduli", ())}


def write_files(problem, folder, comment=""):
    """limits.csv, a file of each stockpile, and target.csv where there is a target. Returns the names of the stockpiles' files."""
    sieves = problem["sieves"]

    def write(name, header, columns):
        rows = zip((sieve["size"] for sieve in sieves), *columns)
        text = "".join(",".join(row) + "\n" for row in [header, *rows])
        (folder / name).write_text(comment + text, encoding="utf-8")

    write("limits.csv", ("size_mm", "passing_min_percent", "passing_max_percent"),
          ([sieve.get("least", "0") for sieve in sieves], [sieve.get("most", "100") for sieve in sieves]))
    for stockpile in problem["stockpiles"]:
        write(stockpile["name"] + ".csv", ("size_mm", "passing_percent"), [stockpile["passing"]])
    if "target" in sieves[0]:
        write("target.csv", ("size_mm", "passing_percent"), [[sieve["target"] for sieve in sieves]])
    return [stockpile["name"] + ".csv" for stockpile in problem["stockpiles"]]


def options(problem, folder):
    """The question as options of mdm blend, beside the files in a folder."""
    aim, names = problem["aim"], [stockpile["name"] for stockpile in problem["stockpiles"]]
    words = ["--spec", folder / "limits.csv", "--minimise", aim, "--step", f"1kg of {problem['steps']}kg"]
    if aim == "cost":
        words += ["--cost", ",".join(f"{name}={stockpile['cost']}" for name, stockpile in zip(names, problem["stockpiles"]))]
    if "deviation" in aim:
        words += ["--target", folder / "target.csv"]
    for name, stockpile in zip(names, problem["stockpiles"]):
        if "least" in stockpile:
            words += ["--share", f"{name}={100 * Fraction(stockpile['least'])}..{100 * Fraction(stockpile['most'])}%"]
    for name, (least, most) in limited(problem).items():
        words += ["--limit", f"{name}={least}..{most}"]
    if "at_most" in problem:
        words += ["--at-most-stockpiles", str(problem["at_most"])]
    return words


def claim(problem, answer):
    """The first lines of the certificate of an answer: the whole question, and the blend, or that there is none."""
    aim, steps, lines = problem["aim"], int(problem["steps"]), ["mdm-certificate blend 1", f"steps {problem['steps']}"]
    for i, stockpile in enumerate(problem["stockpiles"], 1):
        if "least" in stockpile:
            lines.append(f"share {i} {Fraction(stockpile['least'])} {Fraction(stockpile['most'])}")
    if "at_most" in problem:
        lines.append(f"at-most {problem['at_most']}")
    for name, (least, most) in limited(problem).items():
        lines.append(f"modulus {MODULI[name][0]} {Fraction(least)} {Fraction(most)}")
    numbers = {"none": [], "cost": [stockpile.get("cost") for stockpile in problem["stockpiles"]]}
    numbers = numbers.get(aim, [sieve.get("target") for sieve in problem["sieves"]])
    lines.append(" ".join(["minimise", aim, *(str(Fraction(number)) for number in numbers)]))
    counts = [str(Fraction(share) * steps) for share in answer.get("shares", ())]
    return lines + [" ".join(["blend", *(counts or ["none"])])]
