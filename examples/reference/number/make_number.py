"""Makes the answers to number.csv, and their certificates."""

import csv
import json

from answers import mdm, write_table


def make():
    rows = []
    with open("number/number.csv", encoding="utf-8") as table:
        for question in csv.DictReader(table):
            answer = json.loads(mdm("solve", f"number/{question['gradation']}", *question["options"].split(), "--format", "json",
                                    "--proof", f"number/{question['id']}.proof", "--quiet"))
            quantities = [c["quantity"] for c in answer["classes"]]
            rows.append([*question.values(), answer["particles"], " ".join(quantities)])
    write_table("number/number.answers.csv", ["id", "gradation", "options", "particles", "quantities"], rows)
