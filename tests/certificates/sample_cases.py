"""Certificates of samples, VERDICT/NAME in a folder that make.py gives, by samples.py: each has a gradation.csv or
gradation.json, a sample.csv and a certificate proof. Those of `enclosed` are true, too: of ranges, and of laws that give
sizes irrational masses.
"""
import shutil
from fractions import Fraction as F

import samples
from samples import Tolerance

SAND = "size_mm,mass\n1,2\n2,1\n3,0\n"
ROWS = "size_mm,quantity\n1.5,2\n2.5,1\n"


def rows_of(text, unit):
    """The rows of a sample file in the gradation's unit, and N."""
    head, *lines = text.splitlines()
    ranges, N = head.startswith("size_lo_"), int(head.partition("^")[2].partition(",")[0] or 1)
    own = head.removeprefix("size_lo_" if ranges else "size_").partition(",")[0].partition("^")[0]
    scale, rows = (samples.UNITS[own] / samples.UNITS[unit])**N, []
    for line in lines:
        fields = line.split(",")
        q = int(fields.pop()) if head.endswith(",quantity") else 1
        is_open = fields[0].startswith(">")
        sizes = [F(v.lstrip(">")) * scale for v in fields]
        rows.append((sizes[0], sizes[-1], q, is_open))
    return rows, N


def case(gradation, sizes, masses, sample, law=(3, 1), tolerance=(), asked=(), places=None, of=None, d=1, **columns):
    """The text of the gradation, that of the sample, and the certificate; `of` is its verdict where it has several. `sizes` are
    openings to the power d, and `asked` the changes of the question, in the order of their lines."""
    asked = dict(asked)
    g = samples.Gradation([F(v) for v in sizes], masses, d, **columns).asked(**asked)
    rows, N = rows_of(sample, g.unit)
    words = {"pan": "pan-size", "cut": "cut-below", "factor": "size-factor"}
    options = [f"{words[name]} {value}" for name, value in asked.items()]
    choose = lambda said: next(v for v in said if v[0] == of) if of else said[0]
    derived = samples.Derived(g, law, rows, N, places or 0)
    return gradation, sample, samples.certificate(derived, law, Tolerance(tolerance, asked.get("factor")), options, places, choose=choose)


def sand(sample=ROWS, law=(1, 1), tolerance=(), **more):
    return case(SAND, [1, 2, 3], [2, 1, 0], sample, law, tolerance, **more)


def accepted():
    phi = "size_phi,mass\n1,1\n0.5,2\n-0.5,0\n"
    factors = "size_um,mass,tolerance_percent,factor\n100,1,5,1\n200,2,10,2.5\n400,0,0,1\n"
    coarse = dict(factors=[F(1), F(5, 2), F(1)], tolerances=[F(5), F(10), F(0)], unit="um")
    band = [(F(1), F(0), F(0)), (F(2), F(40), F(60)), (F(3), F(100), F(100))]
    envelope = "size_mm,passing_min_percent,passing_max_percent\n1,0,0\n2,40,60\n3,100,100\n"
    cases = {
        "exact": case("size_mm,mass\n1,12\n2,5\n3,0\n", [1, 2, 3], [12, 5, 0], "size_mm,quantity\n1.5,8\n2.5,2\n", (1, 1)),
        "no_match": sand(),
        "spheres": sand(law=(3, 1)),
        "cubes": case("size_mm,mass\n1,12\n2,5\n3,0\n", [1, 2, 3], [12, 5, 0], "size_mm^3,quantity\n3/2,8\n10,1\n"),
        "squares_by_fourth_powers": sand("size_mm^2,quantity\n9/4,2\n6,1\n", (4, 1), [("retained", F(40))]),
        "without_quantities": sand("size_mm\n2\n1.5\n2.5\n", tolerance=[("retained", F(15))]),
        "at_openings": sand("size_mm,quantity\n2,2\n3,1\n", tolerance=[("passing", F(10))]),
        "in_inches": sand("size_in,quantity\n0.06,2\n0.1,1\n", tolerance=[("total", F(50))]),
        "in_metres": sand("size_m,quantity\n15e-4,2\n.0025,1\n", tolerance=[("retained", F(20)), ("total", F(40))]),
        "outside": sand("size_mm,quantity\n1,3\n1.5,2\n2.5,1\n4,2\n"),
        "all_outside": sand("size_mm\n1\n"),
        "one_particle": sand("size_mm\n2.5\n"),
        "one_class": case("size_mm,mass\n0,1\n2,0\n", [0, 2], [1, 0], "size_mm\n0.001\n2\n"),
        "too_little": sand(tolerance=[("retained", F(10))], of="class"),
        "too_much_passes": sand("size_mm,quantity\n1.5,20\n2.5,1\n", tolerance=[("passing", F(10))], of="passing"),
        "too_little_passes": sand(tolerance=[("passing-each", [F(5)])], of="passing"),
        "too_much_in_all": sand(tolerance=[("total", F(20))], of="total"),
        "within_each": sand(tolerance=[("passing-each", [F(13)])]),
        "within_a_band": sand(tolerance=[("band", band)]),
        "beyond_a_band": sand("size_mm,quantity\n1.5,9\n2.5,1\n", tolerance=[("band", band)]),
        "of_phi": case(phi, [F(1, 4), F(1, 2), 2], [1, 2, 0], "size_mm,quantity\n0.6,2\n1,1\n", d=2),
        "at_a_root": case("size_phi,mass\n1,1\n0.5,2\n-0.5,0\n", [F(1, 4), F(1, 2), 2], [1, 2, 0], "size_mm^2\n1/2\n2\n", (2, 1),
                          [("retained", F(30))], d=2),
        "with_factors": case(factors, [100, 200, 400], [1, 2, 0], "size_um\n150\n300\n", tolerance=[("retained", None)], **coarse),
        "with_tolerances": case(factors, [100, 200, 400], [1, 2, 0], "size_mm,quantity\n.15,3\n.3,1\n", (1, 1),
                                [("retained", None), ("passing", None)], **coarse),
        "with_a_pan": case("size_mm,mass\n0,1\n1,2\n2,1\n3,0\n", [0, 1, 2, 3], [1, 2, 1, 0], "size_mm\n0.75\n1.5\n2.5\n",
                           tolerance=[("passing", F(100))], asked={"pan": "0.5"}),
        "cut": case("size_mm,mass\n0,1\n1,2\n2,1\n3,0\n", [0, 1, 2, 3], [1, 2, 1, 0], "size_mm\n0.75\n1.5\n2.5\n", asked={"cut": "1"}),
        "scaled": case(SAND, [1, 2, 3], [2, 1, 0], "size_mm\n3\n5\n", tolerance=[("band", band)], asked={"factor": "2"}),
        "json": case('{"sizes": [1, 2, 3], "masses": [2, 1, 0]}', [1, 2, 3], [2, 1, 0], ROWS, (2, 1)),
    }
    gradation, sample, proof = case(envelope, [1, 2, 3], [50, 50, 0], ROWS, (1, 1), [("band", band)])
    lines = proof.splitlines()
    first = next(i for i, line in enumerate(lines) if line.startswith("band "))
    cases["within_an_envelope"] = gradation, sample, "\n".join(lines[:first] + ["band file"] + lines[first + len(band):]) + "\n"
    return cases


def enclosed():
    return {
        "ranges": sand("size_lo_mm,size_hi_mm,quantity\n1.5,1.6,2\n>2.4,2.5,1\n", tolerance=[("retained", F(20))]),
        "unplaced": sand("size_lo_mm,size_hi_mm\n1.9,2.1\n2.5,2.5\n>2.6,2.7\n", tolerance=[("retained", F(20))], of="class"),
        "ranges_of_one_size": sand("size_lo_mm,size_hi_mm,quantity\n1.5,1.5,2\n2.5,2.5,1\n"),
        "square_roots": sand(law=(1, 2), tolerance=[("retained", F(20))], places=20),
        "cubes_by_squares": sand("size_mm^3,quantity\n3,2\n10,1\n", (2, 1), [("retained", F(30))], places=20),
    }


def changed(case, old, new, of=2):
    assert case[of].count(old) >= 1, (case, old)
    return (*case[:of], case[of].replace(old, new, 1), *case[of + 1:])


def rejected(of):
    within, no_match = of["without_quantities"], of["no_match"]
    return {
        "particles": changed(within, "particles 3", "particles 4"),
        "below": changed(of["outside"], "below 3", "below 2"),
        "below_and_above": changed(changed(of["outside"], "below 3", "below 2"), "above 2", "above 3"),
        "unplaced": changed(within, "particles 3", "particles 3\nunplaced 1"),
        "count": changed(within, "class 1 2 ", "class 1 1 "),
        "share": changed(no_match, "600/11", "601/11"),
        "share_below": changed(no_match, "600/11", "54.5454 54.54545"),
        "class_missing": changed(no_match, "class 2 1 500/11\n", ""),
        "class_twice": changed(no_match, "class 2 1 500/11\n", "class 2 1 500/11\nclass 2 1 500/11\n"),
        "class_out_of_order": changed(no_match, "class 2 1", "class 1 1"),
        "class_0": changed(no_match, "class 1 2", "class 0 2"),
        "largest_error_of_no_class": changed(no_match, "retained-error 1", "retained-error 3"),
        "largest_error_of_class_0": changed(no_match, "retained-error 1", "retained-error 0"),
        "passing_error_of_the_last": changed(no_match, "passing-error 1", "passing-error 2"),
        "passing_error_of_class_0": changed(no_match, "passing-error 1", "passing-error 0"),
        "passing_error_missing": changed(no_match, "passing-error 1 12.121212 12.121213\n", ""),
        "passing_error_of_one_class": changed(of["one_class"], "total-error", "passing-error 1 0 0\ntotal-error"),
        "passing_error_0_of_one_class": changed(of["one_class"], "total-error", "passing-error 0 0 0\ntotal-error"),
        "error_too_small": changed(no_match, "retained-error 1 12.121212 12.121213", "retained-error 1 12.1 12.121212"),
        "error_too_large": changed(no_match, "retained-error 1 12.121212 12.121213", "retained-error 1 12.121213 13"),
        "total": changed(no_match, "total-error 24.242424 24.242425", "total-error 24.242424 24.242424"),
        "condition_2": changed(no_match, "yes yes yes no", "yes no yes no"),
        "condition_3": changed(no_match, "yes yes yes no", "yes yes no no"),
        "condition_3_open": changed(no_match, "yes yes yes no", "yes yes open no"),
        "condition_4": changed(no_match, "yes yes yes no", "yes yes yes yes"),
        "condition_3_of_two_sizes": changed(sand("size_mm\n1.5\n1.6\n2.5\n"), "yes yes no no", "yes yes yes no"),
        "match": (*no_match[:2], no_match[2][:no_match[2].index("verdict ")] + "verdict match\nend\n"),
        "match_of_one_outside": (*of["outside"][:2], of["outside"][2].replace("verdict outside", "verdict match")),
        "outside": (*within[:2], within[2].replace("verdict match", "verdict outside")),
        "at_least_more_than_asked": changed(of["too_little"], "56.666666", "56.666667"),
        "at_most": changed(of["too_little"], "least", "most"),
        "no_class": changed(of["too_little"], "verdict class 1", "verdict class 3"),
        "passing_the_last": (*of["too_little"][:2], of["too_little"][2].replace("verdict class 1", "verdict passing 2")),
        "total_not_asked": changed(no_match, "verdict class 1 54.545454 54.545455 least 66.666666", "verdict total 24 25 most 20"),
        "another_law": changed(no_match, "law 1\n", "law 2\n"),
        "places": changed(no_match, "particles 3", "places 3\nparticles 3"),
        "tolerances_of_no_file": changed(within, "retained 15", "retained file"),
        "passing_each_of_two": changed(of["within_each"], "passing-each 13", "passing-each 13 13"),
        "band_of_no_opening": changed(of["within_a_band"], "band 2 ", "band 2.5 "),
        "band_file_of_no_envelope": changed(within, "retained 15", "band file"),
        "envelope_without_band_file": changed(of["within_an_envelope"], "band file", "retained 15"),
        "no_pan": changed(no_match, "law 1\n", "law 1\npan-size 0.5\n"),
        "no_opening": changed(no_match, "law 1\n", "law 1\ncut-below 1.5\n"),
        "no_opening_of_a_sample_without_form": changed(changed(no_match, "law 1\n", "law 1\ncut-below 1.5\n"), "size_mm", "sizes", 1),
        "more_of_the_sample": changed(no_match, "1.5,2", "1.5,3", 1),
        "a_larger_size": changed(no_match, "1.5,2", "1.5000001,2", 1),
        "another_gradation": changed(no_match, "1,2\n", "1,2.1\n", 0),
    }


def unparsable(of):
    base = of["no_match"]
    proofs = {
        "version": ("sample 1", "sample 2"), "no_version": ("mdm-certificate sample 1\n", ""), "law": ("law 1\n", "law 01\n"),
        "law_above_1000": ("law 1\n", "law 1001\n"), "factor_1": ("law 1\n", "law 1\nsize-factor 1\n"),
        "at_least": ("law 1\n", "law 1\nat-least 2\n"), "particles": ("particles 3", "particles 03"),
        "particles_0": ("particles 3", "particles 0"), "below_0": ("particles 3", "particles 3\nbelow 0"),
        "places": ("particles 3", "places 1001\nparticles 3"), "not_lowest": ("600/11", "1200/22"), "decimal": ("600/11", "54.5"),
        "not_ascending": ("600/11", "55 54"), "the_same_twice": ("600/11", "54.5 54.5"), "percents": ("12.121212 12.121213", "12.2 12.1"),
        "conditions": ("yes no\n", "maybe no\n"), "five_conditions": ("yes no\n", "yes no no\n"), "no_conditions":
        ("conditions yes yes yes no\n", ""), "total_at_least": ("verdict class 1 54.545454 54.545455 least 66.666666",
                                                               "verdict total 24 25 least 20"),
        "no_side": ("least", "at-least"), "index": ("class 1 2", "class 01 2"), "no_end": ("end\n", ""), "more": ("end\n", "end\n\n"),
        "order": ("particles 3\n", "particles 3\nplaces 3\n"), "carriage_returns": ("\n", "\r\n"),
    }
    of_samples = {
        "empty": "", "no_header": "1.5\n", "no_rows": "size_mm\n", "no_last_end": "size_mm\n1.5\n2.5", "blank_line": "size_mm\n1.5\n\n2.5\n",
        "phi": "size_phi\n1\n", "unit": "size_cm\n1\n", "space": "size_mm,quantity\n1.5, 2\n2.5,1\n", "comment": "size_mm\n# 1\n1.5\n",
        "zero": "size_mm\n0\n", "negative": "size_mm\n-1.5\n", "quantity_0": "size_mm,quantity\n1.5,0\n", "quantity_sign": "size_mm,quantity\n1.5,+2\n",
        "quantity_decimal": "size_mm,quantity\n1.5,2.5\n", "quantity_of_1001_digits": "size_mm,quantity\n1.5,1" + "0" * 1000 + "\n",
        "fields": "size_mm\n1.5,2\n", "too_few_fields": "size_mm,quantity\n1.5\n", "more_columns": "size_mm,quantity,density\n1.5,2,1\n",
        "power_1": "size_mm^1\n1\n", "power_beyond": "size_mm^1000001\n1\n", "power_decimal": "size_mm^2\n2.25\n",
        "power_not_lowest": "size_mm^2\n18/8\n", "digits": "size_mm\n1." + "0" * 1000 + "\n", "exponent": "size_mm\n1e401\n",
        "carriage_return": "size_mm\r\n1.5\r\n", "mark": "\ufeffsize_mm\n1.5\n", "comma_number": "size_mm\n1,5\n",
        "too_long": "size_mm\n1e-" + "0" * 2**20 + "1\n",
    }
    return {
        **{"proof_" + name: changed(base, *words) for name, words in proofs.items()},
        **{"sample_" + name: (SAND, text, base[2]) for name, text in of_samples.items()},
        "gradation": ("size_mm,mass\n1,2\n2,1\n3,1\n", *base[1:]),
        "long_sizes": (SAND, "size_mm\n1." + "0" * 900 + "1\n", base[2].replace("law 1\n", "law 1000\n")),
    }


def main(folder):
    shutil.rmtree(folder, ignore_errors=True)
    of = accepted()
    for verdict, cases in (("accepted", of), ("enclosed", enclosed()), ("rejected", rejected(of)), ("unparsable", unparsable(of))):
        for name, (gradation, sample, proof) in cases.items():
            here = folder / verdict / name
            here.mkdir(parents=True)
            (here / ("gradation.json" if gradation.startswith("{") else "gradation.csv")).write_bytes(gradation.encode())
            (here / "sample.csv").write_bytes(sample.encode())
            (here / "proof").write_bytes(proof.encode())
