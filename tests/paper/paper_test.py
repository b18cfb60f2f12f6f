#!/usr/bin/python3
"""paper_test.py SOURCE: the paper of proofs/paper cites what its bibliography has and nothing else, its pictures are there,
and pandoc makes a PDF of it. Exits with 77 where pandoc is missing, unless MDM_REQUIRE_TOOLS is set in the environment."""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

FOLDER = pathlib.Path(sys.argv[1]).resolve() / "proofs/paper"


def equal(one, other, what):
    if one != other:
        sys.exit(f"{what}: {sorted(one ^ other)}")


text = (FOLDER / "paper.md").read_text(encoding="utf-8")
entries = re.findall(r"^@\w+\{(\w+),", (FOLDER / "paper.bib").read_text(encoding="utf-8"), re.MULTILINE)
equal(set(re.findall(r"@(\w+)", text)), set(entries), "cited or listed alone")
for picture in re.findall(r"\]\(([^)]+\.svg)\)", text):
    if not (FOLDER / picture).is_file():
        sys.exit(f"{picture} is not there")

if shutil.which("pandoc") is None or shutil.which("weasyprint") is None:
    print("pandoc or weasyprint is not installed")
    sys.exit(1 if "MDM_REQUIRE_TOOLS" in os.environ else 77)
with tempfile.TemporaryDirectory() as work:
    pdf = pathlib.Path(work) / "paper.pdf"
    subprocess.run(["pandoc", "--citeproc", "--standalone", "paper.md", "--pdf-engine=weasyprint", "-o", pdf], cwd=FOLDER,
                   check=True, timeout=300)
    pages = subprocess.run(["pdftotext", pdf, "-"], capture_output=True, text=True, check=True).stdout
    for heading in re.findall(r"^# (.+)$", text, re.MULTILINE):
        if heading not in pages:
            sys.exit(f"the PDF has no heading {heading}")
    for name in ("Arnold, Lorne", "Voivret"):
        if name not in pages.split("References")[-1]:
            sys.exit(f"{name} is not among the references")
