"""The commands of a page: found, and made small."""

import dataclasses
import re

# Commands that no test runs, and why.
NOT_RUN = [
    (r"^(\./|scripts/)(demo|check)\b", "installs packages and builds; every test runs behind it"),
    (r"^cmake --preset ", "a build of the program; ./check makes two"),
    (r"^cmake --(build|install) build/release(?! --component)", "installs for all users; tests/packages does it in a folder"),
    (r"^scripts/packages", "builds the program as Debian installs it"),
    (r"^scripts/systems", "builds the program in systems of its own"),
    (r"^(build/\S*/tests/|scripts/fuzz)", "fuzzing; ./check replays what it found"),
    (r"^pupflow report (error|stability|validation)( --quick)?( *#| *$)", "takes minutes; tests/report makes it with --quick"),
    (r"^(bench/|build/bench/|PYTHONPATH=build/bench/|perf )", "measures times, and no test looks at those"),
]

# What a page takes for granted, made before its first command.
GRANTED = {
    "README.md": ["printf 'ta,pups\\n0.2,12\\n0.5,8\\n' >points.csv"],
    "docs/reference/compare.md": [
        f"pupflow sweep --vary ta=0.2,0.8 --seeds 2 --steps 60 --set discard=20 --seed {seed} --out {folder}"
        for seed, folder in enumerate(("sweep-a", "sweep-b", "old", "new"), 1)
    ],
    "docs/reference/export.md": ["pupflow run --steps 20 --record run.h5"],
    "docs/reference/info.md": ["pupflow run --steps 20 --record run.h5", "pupflow figure1 --panel 120"],
    "docs/reference/merge.md": [
        f"pupflow sweep --vary ta=0.2,0.8 --seeds 2 --steps 60 --set discard=20 --shard {shard}/2 --out {folder}{shard}"
        for folder in ("shard-", "shards/") for shard in (1, 2)
    ],
    "docs/reference/verify.md": [
        "pupflow run cold --steps 100 --record run.h5 --csv cold.csv", "pupflow figure1 --panel 120"],
}

# What makes a command short: (what it calls, options). An option takes the place of the command's own.
SHORT = "--steps 60 --set discard=20"
SMALLER = [
    (r"pupflow figure2\b", f"--seeds 2 {SHORT}"),
    (r"pupflow sweep(?= .*--(?:vary ta=0:1:|vary alpha=|lhs 100))", f"--seeds 2 {SHORT}"),
    (r"pupflow sweep(?= .*--lhs 100)", "--lhs 4"),
    (r"pupflow sweep(?!.*--steps)(?=.*--seeds [23]\b)", "--steps 200 --set discard=50"),
    (r"pupflow report error(?= cold\b)", f"--quick --seeds 2 {SHORT}"),
    (r"pupflow run(?=.*--steps 100000)", "--steps 3000"),
    (r"pupflow render(?=.*--movie)", "--steps 60 --size 160x120"),
    (r"pupflow render(?=.*--at 800)", "--at 60"),
    (r"pupflow render(?=.*--size (?:640|480))", "--size 160x120"),
    (r"pupflow render (?:pile|carpet)", "--at 10"),
    (r"pupflow render(?=.*--grid)", "--steps 20 --panel 120"),
    (r"pupflow figure1\b", "--panel 120"),
    (r"pupflow live\b", "--exit-after 1"),
    (r"warm_littermate\.py", "--steps 60 --seeds 1"),
    (r"body_map\.py", "--looks 100"),
]

# What else is put in another's place.
REPLACED = [
    (r"^pupflow live", "xvfb-run -a pupflow live"),
    (r"mpirun -n 64 --hostfile machines", "mpirun -n 2"),
    (r"long\.h5\.\d+\.unfinished", "long.h5"),
]

# Lines of output with numbers of the machine: only their words are compared.
MACHINE = [r"µs|^At that rate|^whole step|^(boundary|contact|steering|heat|predict|shape_match|observables|- ) ", r" s\b.* steps?", r", checksum "]

# Options that pages name and no help shows.
FOREIGN = ("--enable-recovery", "--test-events", "--mutate", "--no-install")  # of mpirun, tests and scripts

RUN = ("sh", "bash", "console", "python", "gnuplot")  # languages of blocks that are run
SHOWN = ("cpp", "cmake")  # those that a file of docs/examples holds
TEXT = ("toml", "text")  # those that are no commands


def with_options(line, pattern, options):
    """The command with these options: in place of its own, or behind what `pattern` finds."""
    called = re.search(pattern, line)
    if not called:
        return line
    for option in re.findall(r"--\S+(?: [^-]\S*)?", options):
        name = re.match(r"--set \w+=|--\S+", option)[0]
        own = re.search(re.escape(name) + r"(?<==)\S+|" + re.escape(name) + r" [^-]\S*", line)
        if own:
            line = line.replace(own[0], option)
        else:
            line = f"{line[:called.end()]} {option}{line[called.end():]}"
    return line


@dataclasses.dataclass
class Command:
    line: str  # as the page has it
    expected: str = ""  # what the page says that it prints

    @property
    def why_not(self):
        return next((why for pattern, why in NOT_RUN if re.search(pattern, self.line)), None)

    @property
    def small(self):
        line = self.line
        for pattern, options in SMALLER:
            line = with_options(line, pattern, options)
        for pattern, replacement in REPLACED:
            line = re.sub(pattern, replacement, line)
        return line


@dataclasses.dataclass
class Block:
    language: str
    text: str
    row: int  # of the page, counted from 1

    @property
    def commands(self):
        """The commands of a block for the shell; what a console prints belongs to the one before."""
        if self.language != "console":
            return [Command(line) for line in self.text.splitlines()]
        commands = []
        for line in self.text.splitlines():
            if line.startswith("$ "):
                commands.append(Command(line[2:]))
            elif commands:
                commands[-1].expected += line + "\n"
            else:
                raise SystemExit(f"line {self.row}: a console block begins with '$ '")
        return commands


def blocks(page):
    """The blocks of a page in their order: fenced ones, and indented lines that call the program."""
    found, open_block = [], None
    for row, line in enumerate(page.splitlines(), 1):
        fence = re.match(r" *```(\S*)$", line)
        if fence and open_block is None:
            open_block = Block(fence[1], "", row)
        elif fence:
            found.append(open_block)
            open_block = None
        elif open_block is not None:
            open_block.text += line + "\n"
        elif re.match(r"    +pupflow (?!.*\[)", line):
            found.append(Block("sh", line.strip() + "\n", row))
    return found


def words(text):
    """The lines of an output, without the numbers that differ from machine to machine, and widths of columns."""
    lines = [re.sub(r"\b[0-9a-f]{16}\b|[\d.]+|#+", "", line)
             if any(re.search(pattern, line) for pattern in MACHINE) else line
             for line in text.strip("\n").splitlines()]
    return [re.sub(r"\s+", " ", line).rstrip() for line in lines]


def spoken(page):
    """The pieces of code in running text, without the blocks."""
    text = re.sub(r"^ *```.*?^ *```$", "", page, flags=re.MULTILINE | re.DOTALL)
    return [" ".join(piece.split()) for piece in re.findall(r"`([^`]+)`", text)]
