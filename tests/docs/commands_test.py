#!/usr/bin/env python3
"""Runs every command of a page, in small, and compares what it prints with what the page shows.

usage: commands_test.py SOURCE BUILD PAGE   runs those of a page, e.g. docs/sweeps.md
       commands_test.py SOURCE BUILD        looks through all pages: languages, rows of the tables, and the
                                            verbs and options that the text names

BUILD is the build tree: program and Python module. The tables of commands.py say what is made smaller and what is not
run, and why; what a page has beside that is run as it stands, from top to bottom in one scratch folder.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

import commands

MARK = "-- end of a command --"
OPTION = r"--[a-z][a-z-]*"


def prepare(build, home):
    """A folder that looks like the source tree after ./demo, and a user's environment."""
    here = home / "here"
    (here / "build").mkdir(parents=True)
    (here / "build/release").symlink_to(build)
    shutil.copytree(SOURCE / "docs/examples", here / "docs/examples", ignore=shutil.ignore_patterns("*.png"))
    (home / "bin").mkdir()
    (home / "bin/python3").symlink_to(sys.executable)
    (home / ".config").mkdir()
    os.environ |= {
        "PATH": f"{home}/bin:{build}/bin:{os.environ['PATH']}",
        "HOME": str(home),
        "XDG_CONFIG_HOME": f"{home}/.config",
        "MPLBACKEND": "Agg",
        "MPLCONFIGDIR": f"{home}/.config",
        "OMPI_ALLOW_RUN_AS_ROOT": "1",
        "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
        "OMPI_MCA_rmaps_base_oversubscribe": "1",
        "SLURM_ARRAY_TASK_ID": "1",
    }
    os.chdir(here)


def bash(script):
    """What a script prints, without the progress of long commands. Its exit code must be 0."""
    done = subprocess.run(["bash", "-eu", "-c", script], stdin=subprocess.DEVNULL, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if done.returncode != 0:
        raise SystemExit(f"exit code {done.returncode} of\n{script}\nafter\n{done.stdout}")
    return re.sub(r"^.* \d+ of \d+, .* left\n", "", done.stdout, flags=re.MULTILINE)


def run_shell(block):
    """A block of sh or bash is one script, each command of a console one with an output of its own."""
    script, shown = "", []
    for command in block.commands:
        if command.why_not:
            print(f"not run: {command.line}\n  {command.why_not}")
            continue
        if command.small != command.line:
            print(f"smaller: {command.line}\n  {command.small}")
        refused = " || test $? = 2" if command.expected.startswith("pupflow: ") else ""
        script += command.small + refused + "\n"
        if block.language == "console":
            script += f"echo '{MARK}'\n"
            shown.append(command)
    printed = bash(script).split(MARK + "\n")
    for command, output in zip(shown, printed):
        compare(command, output)


def run_job(block):
    """A job script runs in a folder of its own."""
    here = os.getcwd()
    with tempfile.TemporaryDirectory(dir=here) as folder:
        os.chdir(folder)
        run_shell(block)
        os.chdir(here)


def compare(command, printed):
    """A command that is made smaller prints other numbers."""
    if not command.expected.strip() or command.small != command.line:
        return
    if commands.words(command.expected) != commands.words(printed):
        raise SystemExit(f"{command.line}\nprints\n{printed}\nand the page says\n{command.expected}")


def run_python(block, names):
    exec(compile(block.text, f"line {block.row}", "exec"), names)


def is_shown(block):
    """Whether the code is that of an example, which another test compiles."""
    return any(block.text.strip() in example.read_text() for example in (SOURCE / "docs/examples").iterdir()
               if example.suffix in (".cpp", ".txt"))


def run(page):
    names = {}
    ran = 0
    bash("\n".join(commands.GRANTED.get(page, [])))
    for block in commands.blocks((SOURCE / page).read_text()):
        sys.stdout.flush()
        if block.language in ("sh", "console"):
            run_shell(block)
        elif block.language == "bash":
            run_job(block)
        elif block.language == "gnuplot":
            bash(f"gnuplot <<'END'\n{block.text}END\n")
        elif block.language == "python":
            run_python(block, names)
        elif block.language in commands.SHOWN and not is_shown(block):
            raise SystemExit(f"{page}:{block.row} is no part of a file of docs/examples")
        ran += block.language in commands.RUN
    print(f"{page}: {ran} blocks")


def options_of_verbs():
    """Of each verb the options that its help shows."""
    def said(*words):
        return subprocess.run(["pupflow", *words], capture_output=True, check=True, text=True).stdout

    verbs = re.findall(r"^  ([a-z0-9]+) ", said("--help").partition("Verbs:")[2].partition("\n\n")[0], re.MULTILINE)
    return {verb: set(re.findall(OPTION, said("help", verb))) for verb in verbs}


def unknown_names(text, options):
    """What is wrong with `pupflow VERB --option` or `--option` in the text of a page."""
    for piece in commands.spoken(text):
        called = re.match(r"pupflow ([a-z0-9]+)", piece)
        if called and called[1] not in options:
            yield f"`{piece}`: there is no such verb"
        elif called or re.match(OPTION, piece):
            known = options[called[1]] if called else set(commands.FOREIGN).union(*options.values())
            found = re.findall(OPTION, piece) if called else [re.match(OPTION, piece)[0]]
            yield from (f"`{piece}`: there is no {option}" for option in found if option not in known)


def look_through():
    pages = {str(page.relative_to(SOURCE)): page.read_text()
             for page in sorted(SOURCE.glob("docs/**/*.md")) + [SOURCE / "README.md", SOURCE / "CHANGELOG.md"]}
    known = commands.RUN + commands.SHOWN + commands.TEXT
    options = options_of_verbs()
    lines, wrong = [], []
    for page, text in pages.items():
        wrong += [f"{page}: {problem}" for problem in unknown_names(text, options)]
        for block in commands.blocks(text):
            if block.language not in known:
                wrong.append(f"{page}:{block.row}: a block of the unknown language '{block.language}'")
            elif block.language in ("sh", "bash", "console"):
                lines += [command.line for command in block.commands]
    for pattern in [row[0] for row in commands.NOT_RUN + commands.SMALLER + commands.REPLACED]:
        if not any(re.search(pattern, line) for line in lines):
            wrong.append(f"commands.py: no page has a command like {pattern}")
    print(f"{len(pages)} pages, {len(lines)} lines of commands")
    if wrong:
        raise SystemExit("\n".join(wrong))


SOURCE = pathlib.Path(sys.argv[1]).resolve()
with tempfile.TemporaryDirectory() as scratch:
    prepare(pathlib.Path(sys.argv[2]).resolve(), pathlib.Path(scratch))
    if len(sys.argv) == 4:
        run(sys.argv[3])
    else:
        look_through()
    os.chdir("/")
