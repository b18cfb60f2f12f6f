#!/usr/bin/python3
"""schemas_test.py MDM SOURCE: what the program writes as JSON is what its schemas say, and no other thing is.

MDM is the program, SOURCE the top folder of the project. Exits with 77 where python3-jsonschema is missing, unless
MDM_REQUIRE_TOOLS is set in the environment.
"""

import copy
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

try:
    import jsonschema
except ImportError:
    print("python3-jsonschema is not installed")
    sys.exit(1 if "MDM_REQUIRE_TOOLS" in os.environ else 77)

MDM = str(pathlib.Path(sys.argv[1]).resolve())
SOURCE = pathlib.Path(sys.argv[2]).resolve()
FOLDER = SOURCE / "src/answer/schemas"

SAND = SOURCE / "examples/gradations/athabasca-sand.csv"
LIMITS = SOURCE / "examples/gradations/c33-fine-aggregate-limits.csv"
SANDS = sorted(path for path in SAND.parent.glob("*.csv") if path != LIMITS)
SUITE = SOURCE / "examples/reference/average/suite-2750.jsonl"

COMMANDS = {
    "mdm-answer-1": [
        *(["solve", sand] for sand in SANDS),
        ["solve", SAND, "--min-per-class", "10", "--at-least", "2000"],
        ["solve", SAND, "--at-most", "100"],
        ["solve", "half_phi.csv"],
        ["solve", "beach.csv"],
        ["solve", SAND, "--max-steps", "0"],
        ["solve", SAND, "--max-steps", "0", "--at-most", "1480"],
        ["solve", SAND, "--specimen", "cylinder:5x10", "--void-ratio", "0.6"],
        ["solve", SAND, "--solids-volume", "100"],
        ["solve", SAND, "--law", "power:5/2", "--digits", "30"],
        ["solve", SAND, "--law", "power:2", "--scale", "upper"],
        ["solve", SAND, "--cut-below", "0.25", "--size-factor", "1000", "--spectrum"],
        ["solve", SAND, "--spread", "--seed", "7", "--spectrum"],
        ["solve", SAND, "--tolerance", "retained:1%"],
        ["solve", SAND, "--tolerance", "passing:1%", "--tolerance", "total:2%", "--law", "power:3/1"],
        ["solve", SAND, "--tolerance", "laboratory", "--spread"],
        ["solve", SAND, "--tolerance", "retained:1%", "--node-limit", "1"],
        ["solve", SAND, "--tolerance", "retained:1%", "--at-most", "3"],
        ["solve", SAND, "--tolerance", "total:5%", "--band", "band.csv"],
        ["solve", "--band", LIMITS],
        ["batch", "lines.jsonl"],
        ["batch", "lines.jsonl", "--tolerance", "retained:1%"],
        ["batch", "lines.jsonl", "--proofs", "proofs"],
    ],
    "mdm-totals-1": [
        ["batch", "lines.jsonl", "--shard", "1/2", "-o", "shard.jsonl"],
        ["batch", "lines.jsonl", "--shard", "2/2", "-o", "shard.jsonl", "--proofs", "shard.proofs"],
        ["batch", "lines.jsonl", "--shard", "2/2", "--alone", "-o", "shard.jsonl"],
        ["batch", "made.jsonl", "--shard", "1/1", "--alone", "-o", "shard.jsonl"],
    ],
    "mdm-shard-1": [["suite", "some.json", "--count", "5", "--shard", "2/3"]],
    "mdm-describe-1": [
        *(["describe", sand] for sand in SANDS),
        ["describe", "half_phi.csv"],
        ["describe", "pan.csv"],
        ["describe", "pan.csv", "--extrapolate", "--liquid-limit", "30", "--plastic-limit", "22"],
        ["describe", SAND, "--d", "5,16,95", "--void-ratio", "0.6"],
    ],
    "mdm-sediment-1": [
        *(["describe", sand, "--sediment"] for sand in SANDS),
        ["describe", "half_phi.csv", "--sediment"],
        ["describe", "pan.csv", "--sediment"],
        ["describe", "pan.csv", "--sediment", "--pan-size", "0.002"],
    ],
    "mdm-judge-1": [
        ["judge", *SANDS, "--spec", "astm-c33-fine"],
        ["judge", SAND, "--spec", LIMITS, "--rounding", "1"],
        ["judge", *SANDS, "--spec", "astm-c33-fine", "--limit", "FM=2.3..3.1", "--limit", "retained=..45%"],
        ["judge", "half_phi.csv", "--spec", "band.csv", "--rounding", "5"],
        ["judge", "pan.csv", "--spec", "finer.csv"],
        ["judge", "pan.csv", "--spec", "edge.csv"],
    ],
    "mdm-report-1": [
        ["report", SAND],
        ["report", *SANDS, "--spec", "astm-c33-fine", "--client", "A & B", "--field", "Project=Quay", "--d", "5"],
        ["report", "pan.csv", "--spec", "edge.csv", "--extrapolate"],
    ],
    "mdm-number-1": [
        ["solve", "number.csv"],
        ["solve", "number.csv", "--tolerance", "retained:1%"],
        ["solve", "number.csv", "--tolerance", "total:0"],
    ],
    "mdm-shares-1": [
        ["describe", "number.csv"],
        ["describe", "half_phi.csv", "--by-number"],
        ["describe", "pan.csv", "--by-number"],
        ["describe", SAND, "--by-number", "--digits", "30"],
    ],
    "mdm-rule-1": [
        *(["judge", *SANDS, "--stability", rule] for rule in ("kenney-lau", "kezdi", "burenkova")),
        ["judge", "pan.csv", "--stability", "burenkova"],
        *(["judge", SAND, "--filter-for", "pan.csv", "--rule", rule] for rule in ("terzaghi", "usbr", "nrcs", "fema")),
        ["judge", *SANDS, "--filter-for", SAND, "--rule", "nrcs-1994", "--dispersive", "--no-regrade"],
    ],
    "mdm-reading-1": [
        *(["convert", "--dry-run", sand] for sand in SANDS),
        ["convert", "--dry-run", "half_phi.csv"],
        ["convert", "--dry-run", "pan.csv"],
        ["convert", "--dry-run", SAND.parent / "formats/mastersizer.csv", "--specimen-id", "Silt B"],
    ],
    "mdm-problem-1": [
        *(["convert", sand, "--problem", "json"] for sand in SANDS),
        ["convert", SAND, "--problem", "json", "--tolerance", "retained:1%", "--min-per-class", "2", "--at-least", "100"],
        ["convert", SAND, "--problem", "json", "--tolerance", "total:1%", "--tolerance", "passing:2%"],
        ["convert", "pan.csv", "--problem", "json"],
    ],
    "mdm-generate-1": [
        ["generate", "--beta", "3,3", "--dmin", "0.02", "--dmax", "1.98", "--dimension", "2", "--classes", "6"],
        ["generate", "--beta", "1,3", "--dmin", "0.1", "--ratio", "4", "--at-least", "100", "--sizes", "--seed", "1"],
        ["generate", "--beta", "1,1", "--dmin", "1", "--ratio", "4", "--at-least", "100", "--dimension", "2",
         "--classing", "regular", "--sizes"],
        ["generate", "--curve", SAND, "--method", "match", "--sizes", "--table", "5"],
        ["generate", "--curve", SAND, "--method", "match", "--spread", "--sizes", "--at-most", "2001"],
        ["generate", "--curve", SAND, "--between", "stair", "--points", "0", "--at-most", "1000000"],
    ],
    "mdm-blend-1": [
        ["blend", "a.csv", "b.csv", "--spec", "band.csv"],
        ["blend", "a.csv", "b.csv", "--spec", "band.csv", "--cost", "a=1,b=2", "--share", "a=..60%", "--all", "5"],
        ["blend", "a.csv", "b.csv", "--spec", "band.csv", "--target", "a.csv", "--at-most-stockpiles", "1", "--step", "10%"],
        ["blend", "a.csv", "b.csv", "--spec", "band.csv", "--target", "a.csv", "--minimise", "max-deviation"],
        ["blend", "a.csv", "b.csv", "--spec", "band.csv", "--share", "a=95..100%"],
        ["blend", "--problems", "problems.jsonl"],
        ["blend", "a.csv", "b.csv", "--spec", "band.csv", "--limit", "FM-EN=0..2", "--limit", "FM=..3", "--target", "a.csv"],
        ["blend", "a.csv", "b.csv", "--spec", "band.csv", "--limit", "FM=10..11"],
        ["blend", "a.csv", "b.csv", "--spec", "band.csv", "--node-limit", "0", "--step", "3kg of 102kg", "--cost", "a=1,b=2"],
    ],
    "mdm-packing-1": [
        ["pack", "--beta", "1,1", "--span", "0.5", "--at-least", "200"],
        ["pack", "--beta", "1,1", "--span", "0.5", "--at-least", "200", "--walls", "--rule", "drop", "--positions"],
        ["pack", "discs.csv", "--width", "10"],
        ["pack", SAND, "--spread", "--at-least", "300"],
        ["verify", "discs.csv", "discs.packing"],
        ["verify", "discs.csv", "gasket.packing"],
    ],
    "mdm-apollonian-1": [
        ["pack", "--apollonian", "equal", "--smallest", "1/50"],
        ["pack", "--apollonian", "-11,21,24,28", "--smallest", "0.02"],
    ],
    "mdm-accessible-1": [
        ["generate", "--accessible", "--span", "0.97", "--a", "1:4:1", "--b", "1,2", "--dimension", "2"],
    ],
    "mdm-inverse-1": [
        ["generate", "--cu", "4", "--cc", "2", "--span", "0.95"],
        ["generate", "--cu", "6", "--cc", "7", "--span", "0.5,0.9"],
    ],
    "mdm-verify-1": [
        ["verify", SAND, "answer.json"],
        ["verify", SAND, "sample.csv", "--tolerance", "1%"],
        ["verify", SAND, "sample.csv", "--snap", "1e-3", "--law", "power:5/2"],
        ["verify", "pan.csv", "sample.csv", "--tolerance", "100%"],
        ["verify", "beach.csv", "grains.csv"],
        ["verify", SAND, "places.txt", "--packing"],
        ["verify", SAND, "places.txt", "--packing", "--specimen", "cylinder:20x20", "--margin", "1"],
        ["verify", SAND, "places.txt", "--packing", "--box", "20x20x20", "--periodic", "xyz", "--margin", "1"],
    ],
    "mdm-timesteps-1": [
        ["verify", SAND, "run.dump", "--over-time"],
        ["verify", SAND, "sizes.dump", "--over-time", "--law", "power:5/2"],
        ["verify", "pan.csv", "sizes.dump", "--over-time", "--tolerance", "100%"],
    ],
    "mdm-tradeoff-1": [
        ["tradeoff", SAND],
        ["tradeoff", SAND, "--kind", "total", "--tolerances", "0,5", "--node-limit", "1"],
        ["tradeoff", "pan.csv", "--kind", "passing", "--min-per-class", "2"],
    ],
    "mdm-published-1": [
        ["published", "rounded", SAND],
        ["published", "fixed-size", SAND, "--max-iterations", "3"],
        ["published", "spanned-integer", SAND, "--start", "0.5", "--increments", "1"],
        ["published", "spanned-integer", "pan.csv"],
    ],
    "mdm-crosscheck-1": [
        ["crosscheck", "lines-good.jsonl", "answers.csv", "--by", "setting"],
        ["crosscheck", "lines-good.jsonl", "answers.csv", "--reasons"],
        ["crosscheck", "lines-good.jsonl", "--solver", "echo '{}'"],
        ["crosscheck", "lines-good.jsonl", "answers.csv", "--max-steps", "0"],
    ],
    "mdm-crosscheck-blends-1": [
        ["crosscheck", "problems.jsonl", "blends.jsonl"],
        ["crosscheck", "problems.jsonl", "--solver", "exit 1"],
    ],
    "mdm-gradation": [
        *(["convert", sand] for sand in SANDS),
        ["convert", "factors.csv"],
    ],
}

# Fields that an object may be without.
OPTIONAL = {
    "mdm-describe-1": {"kKozenyCarman"},
    "mdm-report-1": {"kKozenyCarman"},
    "mdm-answer-1": {"upper_bound", "spectrum", "seed", "question", "start", "scale_power", "sizes", "size_power",
                     "lower_power", "upper_power", "proof", "material", "factor"},
    "mdm-verify-1": {"material", "other_materials"},
    "mdm-generate-1": {"quality", "curve", "sizes"},
    "mdm-packing-1": {"positions", "judgement"},
    "mdm-blend-1": {"id"},
    "mdm-crosscheck-1": {"setting"},
    "mdm-totals-1": {"proofs", "index", "suite", "made", "alone"},
    "mdm-gradation": {"id", "unit", "factors", "tolerances_percent"},
}

FILES = {
    "some.json": '{"schema": "mdm-suite-1", "sieves": {"from": 1, "ratio": 2}, "classes": 3, "masses": {"kind": "random"}}',
    "discs.csv": "class,size_lo,size_hi\n1,1,1\n1,1,1\n2,2,2\n",
    "number.csv": "size_mm,number_percent\n1,50\n2,33.3\n4,0\n8,16.7\n16,0\n",
    "beach.csv": "size_mm,mass,factor,material\n1,5,2.65,quartz\n2,0,2.65,quartz\n0.5,1,2.75,shell\n4,0,2.75,shell\n",
    "grains.csv": "size_mm,quantity,material\n1.5,20,quartz\n3,2,shell\n3,1,quartz\n2,1,mica\n",
    "half_phi.csv": "size_phi,mass\n-2,0\n-1.5,1\n-1,0\n-0.5,0\n0,1\n",
    "pan.csv": "size_mm,passing_percent\n4.75,100\n2,80\n0.425,45\n0.075,12\n",
    "a.csv": "size_mm,passing_percent\n1,100\n0.25,80\n0.1,0\n",
    "b.csv": "size_mm,passing_percent\n1,100\n0.25,31\n0.1,0\n",
    "factors.csv": "size_um,mass,factor,tolerance_percent\n2000,0,1,1\n1000,5,1.5,0.5\n500,3,2,0.5\n",
    "finer.csv": "size_mm,passing_min_percent,passing_max_percent\n0.02,0,5\n",
    "edge.csv": "size_mm,passing_min_percent,passing_max_percent\n0.425,45,60\n",
    "band.csv": "size_mm,passing_min_percent,passing_max_percent\n0.25,50,70\n",
    "run.dump": "".join(
        f"ITEM: TIMESTEP\n{step}\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp pp ff\n0 1\n0 1\n0 1\nITEM: ATOMS x y z radius\n"
        "0.5 0.5 0.1 0.0001\n0.5 0.5 0.10018 0.0001\n" for step in (0, 10)),
    "sizes.dump": "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: ATOMS diameter\n0.0001\n0.0002\n",
    "places.txt": "1 1 1 0.1\n1 1 1.19 0.1\n5 5 0.25 0.25\n9 9 12 0.4\n9 9.7 12 0.3\n3 3 3 0.06\n",
    "sample.csv": "size_mm,quantity\n0.05,3000\n0.1,300\n0.12,100\n0.13,200\n0.2,250\n0.4,20\n0.8,2\n0.9,1\n3,1\n",
    "problems.jsonl": '{"id":"a","stockpiles":[{"name":"A","passing":["60"],"cost":"0"},{"name":"B","passing":["1/3"],"cost":"2"}],'
                      '"sieves":[{"size":"4","least":"10","most":"20"}],"aim":"cost"}\n',
    "blends.jsonl": '{"id":"a","percents":["20","80"]}\n{"id":"a","status":"infeasible"}\n{"percents":[]}\n{"id":"b"}\n',
    "answers.csv": "id,quantities,sizes_mm,setting\na,2 1,,x\na,3 1,0.1 0.2,y\nb,1 1,,x\nb,,,y\nc,1,,x\n",
}
GOOD_LINES = [
    '{"id": "a", "sizes": ["0.1", "0.2", "0.4"], "masses": ["1", "3", "0"]}',
    '{"id": "b", "unit": "um", "sizes": [400, 200, 100], "masses": [0, 2.5, 1]}',
    '{"sizes": ["0", "0.5", "1"], "masses": ["1", "1", "0"], "factors": ["1", "2.65", "1"]}',
]
BAD_LINES = ['{"id": "c", "sizes": ["0.1"], "masses": ["1"]}', "no JSON"]

# What the reader of gradations refuses, and the schema too.
NO_GRADATIONS = [
    '{"sizes": ["0.1", "0.2"]}',
    '{"sizes": ["0.1"], "masses": ["0"]}',
    '{"sizes": ["0.1", "0,2"], "masses": ["1", "0"]}',
    '{"sizes": ["0.1", "0.2"], "masses": ["-1", "0"]}',
    '{"sizes": ["0.1", null], "masses": ["1", "0"]}',
    '{"unit": "cm", "sizes": ["0.1", "0.2"], "masses": ["1", "0"]}',
    '{"sizes": "0.1", "masses": ["1", "0"]}',
]

# What mdm suite takes, and the schema too.
SUITES = [
    '{"schema": "mdm-suite-1", "sieves": {"series": "half-phi", "from": 0.25}, "masses": {"kind": "random"}}',
    '{"schema": "mdm-suite-1", "id": "a", "unit": "um", "sieves": {"list": [8, "2", 4], "neighbours": true}, "classes": 1,'
    ' "digits": "12", "masses": [{"kind": "ties", "at": "upper", "quantities": [1, 3], "law": "power:2"}]}',
    '{"schema": "mdm-suite-1", "sieves": {"from": [1, 2], "to": 50, "digits": 4}, "classes": [3, "9"],'
    ' "masses": {"kind": "beta", "a": [0.5, 2], "b": "1"}}',
    '{"schema": "mdm-suite-1", "sieves": {"from": 1, "ratio": [1.5, 2]}, "classes": 5, "masses":'
    ' [{"kind": "lognormal", "median": 0.5, "deviation": [1, 2]}, {"kind": "gap-graded", "empty": 2}]}',
]
# What it refuses, and the schema too.
NO_SUITES = [
    '{"schema": "mdm-suite-1", "sieves": {"list": [1, 2]}}',
    '{"sieves": {"list": [1, 2]}, "masses": {"kind": "random"}}',
    '{"schema": "mdm-suite-1", "sieves": {"list": [1, 2], "series": "phi"}, "masses": {"kind": "random"}}',
    '{"schema": "mdm-suite-1", "sieves": {"list": [1]}, "masses": {"kind": "random"}}',
    '{"schema": "mdm-suite-1", "sieves": {"series": "ISO"}, "masses": {"kind": "random"}}',
    '{"schema": "mdm-suite-1", "sieves": {"list": [1, 2]}, "masses": {"kind": "rand"}}',
    '{"schema": "mdm-suite-1", "sieves": {"list": [1, 2]}, "masses": {"kind": "beta", "a": 1}}',
    '{"schema": "mdm-suite-1", "sieves": {"list": [1, 2]}, "masses": {"kind": "random"}, "count": 3}',
    '{"schema": "mdm-suite-1", "sieves": {"from": 1, "to": 8}, "classes": [1, 2, 3], "masses": {"kind": "random"}}',
    '{"schema": "mdm-suite-1", "sieves": {"list": [1, -2]}, "masses": {"kind": "random"}}',
]

failures = []


def check(condition, message):
    if not condition:
        failures.append(message)
        print("failed:", message)


def shown(command):
    return " ".join(str(word).replace(str(SOURCE) + "/", "") for word in command)


def values_of(command):
    """The JSON values that a command writes: of batch one a line, of a shard its totals, of suite the line before those of a shard. Exit codes 1 and 3 come with a
    report too."""
    options = [] if command[0] in ("batch", "suite") else ["--format", "json"]
    run = subprocess.run([MDM, *map(str, command), *options], capture_output=True, text=True, timeout=120)
    bad_line = command[0] == "batch" and run.returncode == 2
    check(run.returncode in (0, 1, 3) or bad_line, f"{shown(command)}: exit {run.returncode}: {run.stderr}")
    try:
        if command[0] == "suite":
            return [json.loads(run.stdout.splitlines()[0])]
        if "--shard" in command:
            return [json.loads(pathlib.Path("shard.jsonl.totals").read_text(encoding="utf-8"))]
        texts = run.stdout.splitlines() if command[0] == "batch" else [run.stdout]
        return [json.loads(text) for text in texts]
    except json.JSONDecodeError as error:
        check(False, f"{shown(command)}: {error}: {run.stdout[max(error.pos - 60, 0):error.pos + 20]}")
        return []


def objects(value):
    """All objects in a JSON value."""
    if isinstance(value, dict):
        yield value
        for part in value.values():
            yield from objects(part)
    elif isinstance(value, list):
        for part in value:
            yield from objects(part)


def shortened(value):
    """The same with lists of three entries at most."""
    if isinstance(value, dict):
        return {key: shortened(part) for key, part in value.items()}
    return [shortened(part) for part in value[:3]] if isinstance(value, list) else value


def form(value):
    """What two values have in common that differ in texts alone."""
    if isinstance(value, dict):
        return tuple((key, form(part)) for key, part in value.items())
    return frozenset(map(form, value)) if isinstance(value, list) else type(value)


def check_strict(validator, document, what):
    """The schema refuses the document with a field more in any object, and without a field that is not optional."""
    optional = OPTIONAL.get(validator.schema["title"], set())
    check(validator.is_valid(document), f"{what}: refused with shorter lists")
    for place, original in enumerate(objects(document)):
        if "gmp" in original:  # the versions: which libraries there are is not the schema's matter
            continue
        changed = copy.deepcopy(document)
        some = list(objects(changed))[place]
        some["a new field"] = "1"
        check(not validator.is_valid(changed), f"{what}: a new field in object {place} is accepted")
        del some["a new field"]
        for key in set(original) - optional:
            value = some.pop(key)
            check(not validator.is_valid(changed), f"{what}: object {place} is accepted without {key}")
            some[key] = value


def check_schema(name, schema):
    jsonschema.Draft202012Validator.check_schema(schema)
    check(schema["title"] == name, f"{name}: its title is {schema['title']}")
    for part in objects(schema):
        if isinstance(part.get("properties"), dict) and "required" in part and part.get("type") == "object":
            check("additionalProperties" in part, f"{name}: an object takes all fields: {sorted(part['properties'])}")
            check(set(part["required"]) <= set(part["properties"]), f"{name}: a required field is not described")


def main():
    schemas = {path.name.removesuffix(".schema.json"): json.loads(path.read_text(encoding="utf-8"))
               for path in FOLDER.glob("*.schema.json")}
    written = {name for path in (SOURCE / "src").rglob("*.[ch]pp")
               for name in re.findall(r'mdm-[a-z-]+-[0-9]+', path.read_text(encoding="utf-8"))}
    check(written | {"mdm-gradation"} == set(schemas), f"schemas {sorted(schemas)}, but src names {sorted(written)}")
    check(set(COMMANDS) | {"mdm-suite-1"} == set(schemas), "every schema has commands in this test")
    validators = {}
    for name, schema in schemas.items():
        check_schema(name, schema)
        resolver = jsonschema.RefResolver("", schema, {f"{other}.schema.json": one for other, one in schemas.items()})
        validators[name] = jsonschema.Draft202012Validator(schema, resolver=resolver)

    for name, text in FILES.items():
        pathlib.Path(name).write_text(text, encoding="utf-8")
    with open(SUITE, encoding="utf-8") as suite:
        some = [next(suite).rstrip() for _ in range(50)]
    pathlib.Path("lines-good.jsonl").write_text("\n".join(GOOD_LINES) + "\n", encoding="utf-8")
    pathlib.Path("lines.jsonl").write_text("\n".join(GOOD_LINES + BAD_LINES + some) + "\n", encoding="utf-8")
    answer = subprocess.run([MDM, "solve", SAND, "--format", "json"], capture_output=True, text=True, check=True)
    pathlib.Path("answer.json").write_text(answer.stdout, encoding="utf-8")

    for options in (["discs.csv", "--width", "10", "-o", "discs.packing"],
                    ["--apollonian", "equal", "--smallest", "1/9", "-o", "gasket.packing"]):
        subprocess.run([MDM, "pack", *options], capture_output=True, check=True)

    subprocess.run([MDM, "suite", "some.json", "--count", "5", "--shard", "1/1", "-o", "made.jsonl"], check=True)

    documents, forms = 0, set()
    for name, commands in COMMANDS.items():
        for command in commands:
            values = values_of(command)
            check(values, f"{shown(command)}: no JSON")
            for value in values:
                documents += 1
                error = jsonschema.exceptions.best_match(validators[name].iter_errors(value))
                check(error is None, f"{shown(command)}: {error and (error.json_path, error.message[:300])}")
            for document in map(shortened, values[:1]):
                if form(document) not in forms:
                    check_strict(validators[name], document, shown(command))
                forms.add(form(document))
    for line in GOOD_LINES + some:
        check(validators["mdm-gradation"].is_valid(json.loads(line)), f"no gradation to the schema: {line}")
    for line in NO_GRADATIONS:
        run = subprocess.run([MDM, "convert", "-"], input=line, capture_output=True, text=True)
        check(run.returncode == 2, f"the reader takes {line}")
        check(not validators["mdm-gradation"].is_valid(json.loads(line)), f"the schema takes {line}")
    for good, texts in ((True, SUITES), (False, NO_SUITES)):
        for text in texts:
            run = subprocess.run([MDM, "suite", "-", "--count", "9"], input=text, capture_output=True, text=True)
            check(run.returncode == (0 if good else 2), f"mdm suite: exit {run.returncode} of {text}: {run.stderr}")
            check(validators["mdm-suite-1"].is_valid(json.loads(text)) == good, f"the schema errs on {text}")
            for line in run.stdout.splitlines():
                check(validators["mdm-gradation"].is_valid(json.loads(line)), f"no gradation to the schema: {line}")
    print(f"{documents} JSON values, {len(schemas)} schemas, {len(failures)} failures")
    return 1 if failures else 0


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    result = main()
    os.chdir("/")
sys.exit(result)
