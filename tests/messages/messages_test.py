#!/usr/bin/python3
"""messages_test.py SOURCE: no text of the library, and no error of the program, which the modules run too, names an option
as the command line has it: option("name") does that, in the spelling of the front end that speaks.

SOURCE is the top folder of the project. A command of the program that is quoted, `mdm convert --help`, stays one.
"""

import pathlib
import re
import sys

SOURCE = pathlib.Path(sys.argv[1]).resolve()

# The rooms above the program, which it shares with Python and JavaScript.
ROOMS = ("text", "number", "gradation", "soil", "judge", "match", "proof", "sets", "blend", "packing", "particles", "answer", "report", "plot", "document", "crosscheck", "papers", "files", "ask")

# Parts of commands, of the models that export writes, and of helps, by file.
EXCEPTIONS = {
    "src/particles/model_yade.cpp": {"--size-unit"},  # of the mdm verify of a model's head
    "src/particles/settle_model.cpp": {"--tolerance"},  # of the same
    "src/particles/settle_script.cpp": {"--snap", "--specimen", "--pan-size", "--cut-below", "--size-factor"},
    "src/particles/settle_phases.cpp": {"--start"},  # a model's own message
    "src/particles/yade_course.cpp": {"--start"},  # the same of YADE
    "src/ask/export_report.cpp": {"--size-unit", "--specimen"},  # of the mdm verify that it quotes
    "src/papers/deposit_line.hpp": {"--out"},  # of mdm study
    "src/files/sample_file.cpp": {"--to", "--seed"},  # of the mdm export that it quotes
    # Of the commands beside statements, behind a comma in them.
    "src/papers/model_statements.cpp": {"--dmin", "--dmax", "--span", "--dimension", "--table", "--classes", "--sizes", "--format"},
    "src/papers/shape_statements.cpp": {"--dmin", "--dmax", "--table"},
}

LITERAL = r'"(?:[^"\\\n]|\\.)*"'
TEXTS = re.compile(rf'//[^\n]*|/\*.*?\*/|^\s*#[^\n]*|R"(\w*)\((.*?)\)\1"|\'(?:[^\'\\]|\\.)+\'|{LITERAL}(?:\s+{LITERAL})*',
                   re.DOTALL | re.MULTILINE)
# The help in a row of a table of options, in which src/ask/write_modules spells the options for the modules.
HELP = re.compile(rf"OptionKind::\w+,\s*{LITERAL}(?:\s+{LITERAL})*")
THROWN = re.compile(r"throw .*?\);\n", re.DOTALL)
COMMAND = re.compile(r"\bmdm [a-z][^;:,()]*")
OPTION = re.compile(r"(?<![\w-])--[a-z][a-z-]*")


def texts(source):
    """The literals of a file, those that stand beside each other as one."""
    for found in TEXTS.finditer(source):
        if found[2] is not None:
            yield found[2]
        elif found[0].startswith('"'):
            yield "".join(part[1:-1] for part in re.findall(LITERAL, found[0]))


def options_of(source):
    source = HELP.sub("", source)
    return [option for text in texts(source) for option in OPTION.findall(COMMAND.sub("", text))]


def check_reader():
    """The test finds what it is about, and that alone."""
    found = options_of('// "--a"\nf("leave out "\n  "--law; see mdm solve --help", R"x(--raw)x", \'"\', "a--b", "--"); --i;')
    assert found == ["--law", "--raw"], found
    found = options_of('{"a", "N", OptionKind::text,\n "as --b " "and --c", &T::a}, f("--d")')
    assert found == ["--d"], found
    found = options_of("".join(THROWN.findall('f("--a");\nthrow InputError("b" +\n  g(c) + "--d");\nf("--e");\n')))
    assert found == ["--d"], found


def main():
    check_reader()
    failures, used, files = [], {name: set() for name in EXCEPTIONS}, 0

    def judge(path, options):
        name = path.relative_to(SOURCE).as_posix()
        for option in options:
            if option in EXCEPTIONS.get(name, ()):
                used[name].add(option)
            else:
                failures.append(f'{name}: {option}: write option("{option[2:]}")')

    for path in sorted((SOURCE / "src/cli").glob("*.cpp")):
        judge(path, options_of("".join(THROWN.findall(path.read_text(encoding="utf-8")))))
    for room in ROOMS:
        for folder in (SOURCE / "src" / room, SOURCE / "include/mdm" / room):
            for path in sorted(folder.glob("*.[ch]pp")):
                files += 1
                judge(path, options_of(path.read_text(encoding="utf-8")))
    failures += [f"{name}: no exception any more: {option}" for name, all_of_it in EXCEPTIONS.items()
                 for option in sorted(all_of_it - used[name])]
    print(f"{files} files, {len(failures)} failures", *failures, sep="\n")
    return 1 if failures or files < 300 else 0


sys.exit(main())
