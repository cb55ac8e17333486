#!/usr/bin/env python3
"""Makes the n-th call of each kind fail and looks at what the program leaves behind.

faults_test.py PROGRAM SHIM CASE [KIND...]: one row of CASES. Each kind of fault is tried at the
first, the last and some calls between; with PUPFLOW_FAULTS=all at every call, with
PUPFLOW_FAULTS=places too, but of the allocations that come with the same innermost callers only at the
first. It happens once, or from then on. After a fault the exit code must
be a promised one, with one line on standard error; a file under its final name must be whole, and
nothing else may lie there. Where the code is 0 the files are those of an undisturbed run. A folder
of a sweep must be completed by the same command.
"""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

MEMORY = "/dev/shm"  # files that take no time to reach a disk
SMALL = "--set pups=2 --set face_points=2 --steps 20 --threads 1 --quiet".split()
SWEEP = "--set pups=2 --set face_points=2 --steps 4 --set discard=1 --threads 1 --quiet".split()
PICTURE = "--set pups=1 --set face_points=2 --threads 1 --quiet".split()

# Kinds of faults that every case meets, and the codes that may follow. Memory is 2, as an input that
# asks for too much.
FILES = {0, 4}
KINDS = {"read": FILES, "write": FILES, "short": {0}, "pwrite": FILES, "fsync": FILES,
         "rename": FILES, "open": FILES, "close": FILES, "mkdir": FILES, "malloc": {0, 2, 4},
         "thread": {0, 2}}


class Case:
    """A command, the files that it makes, and what else holds of it."""

    def __init__(self, words, needs=(), folder=None, codes=None, kinds=KINDS, most=12,
                 hdf5=False, drawn=False):
        self.words, self.needs = words, needs
        self.folder = folder  # of a sweep; its command is given again after a fault
        self.codes = codes or set()  # that may follow beside those of KINDS
        self.kinds, self.most = kinds, most
        self.hdf5 = hdf5  # an HDF5 file is read or written
        self.drawn = drawn  # by OpenGL; Mesa waits for ever for a thread that it did not get


GRID = ["--vary", "ta=0:1:2", "--seeds", "2", "--record"]
CASES = {
    "csv": Case(["run", *SMALL, "--csv", "a.csv"]),
    "pups": Case(["run", *SMALL, "--pups", "a.csv"]),
    "record": Case(["run", *SMALL, "--record", "a.h5", "--record-every", "1"],
                   hdf5=True),
    "checkpoint": Case(["run", *SMALL, "--checkpoint", "a.h5"], hdf5=True),
    "scene": Case(["run", "in.toml", *SMALL, "--csv", "a.csv"], ["in.toml"]),
    "like": Case(["run", "--like", "in.csv", "--quiet", "--csv", "a.csv"], ["in.csv"]),
    "from": Case(["run", "--from", "in.h5", "--quiet", "--steps", "30", "--csv", "a.csv"],
                 ["in.h5"], hdf5=True),
    "render": Case(["render", *PICTURE, "--at", "0,1", "--size", "64x48", "--no-bar", "--out",
                    "f/%d.png"], codes={5}, most=6, drawn=True,
                   kinds={kind: codes for kind, codes in KINDS.items() if kind != "thread"}),
    "threads": Case(["run", "--set", "pups=64", "--set", "face_points=3", "--steps", "3",
                     "--threads", "4", "--quiet", "--csv", "a.csv"], kinds={"thread": {0}}),
    "sweep": Case(["sweep", *SWEEP, *GRID, "--out", "s"], folder="s", most=2),
    "sweep_threads": Case(["sweep", *SWEEP[:-3], "--threads", "3", "--quiet", *GRID, "--out", "s"],
                          folder="s", kinds={"thread": {0}}),
    "merge": Case(["merge", "in1", "in2", "--out", "s", "--quiet"], ["in1", "in2"], folder="s",
                  most=2),
    "figure2": Case(["figure2", *SWEEP, "--seeds", "1", "--out", "s"], folder="s", most=2),
}

PREPARED = {
    "in.toml": None,
    "in.csv": ["run", *SMALL, "--csv", "in.csv"],
    "in.h5": ["run", *SMALL, "--checkpoint", "in.h5"],
    "in1": [*CASES["sweep"].words[:-1], "in1", "--shard", "1/2"],
    "in2": [*CASES["sweep"].words[:-1], "in2", "--shard", "2/2"],
}


def files_of(folder):
    return {str(path.relative_to(folder)): path.read_bytes()
            for path in sorted(folder.rglob("*")) if path.is_file()}


class Trial:
    def __init__(self, program, shim, case):
        self.program, self.shim, self.case = program, shim, case
        self.scratch = pathlib.Path(tempfile.mkdtemp(
            prefix="pupflow-faults-", dir=MEMORY if os.access(MEMORY, os.W_OK) else None))
        self.store = self.scratch / "store"
        self.store.mkdir()
        for name in case.needs:
            if PREPARED[name] is None:
                (self.store / name).write_text('title = "t"\nta = 0.2\n')
            else:
                subprocess.run([program, *PREPARED[name]], cwd=self.store, check=True)
        self.reference = self.run("read:0")[3]
        self.faults = self.problems = self.crashes = self.accounts = 0

    def run(self, fault, again=False, **variables):
        """Code, standard error, whether a call failed, and the files that are there then."""
        folder, report = self.scratch / "work", self.scratch / "report"
        if not again:
            shutil.rmtree(folder, ignore_errors=True)
            shutil.copytree(self.store, folder)
        report.unlink(missing_ok=True)
        environment = dict(os.environ, LD_PRELOAD=self.shim, PUPFLOW_FAULT=fault,
                           PUPFLOW_FAULT_REPORT=str(report), PUPFLOW_FAULT_PROGRAM="pupflow",
                           **variables)
        done = subprocess.run([self.program, *self.case.words], cwd=folder, env=environment,
                              stdin=subprocess.DEVNULL, capture_output=True, timeout=60)
        self.report = report.read_text() if report.exists() else ""
        return done.returncode, done.stderr.decode(), "fired" in self.report, files_of(folder)

    def count(self, kind):
        self.run(kind + ":0")
        return int(self.report.split("count=")[1])

    def calls(self, kind):
        """Which calls fail, one a run."""
        count, which = self.count(kind), os.environ.get("PUPFLOW_FAULTS")
        if which == "places" and kind == "malloc":
            return self.places()
        if which in ("all", "places"):
            return range(1, count + 1)
        most = self.case.most
        near = [round(count ** (i / most)) for i in range(most + 1)] if count else []
        return sorted({n for x in near for n in (x, count + 1 - x)})

    def places(self):
        """The first allocation by each few innermost callers, but those of a graphics driver."""
        places = self.scratch / "places"
        self.run("malloc:0", PUPFLOW_FAULT_PLACES=str(places))
        return [int(line) for line in places.read_text().split()]

    def complain(self, fault, text):
        self.problems += 1
        print(f"{' '.join(self.case.words)}\n  with {fault}: {text}")

    def look(self, fault, allowed):
        try:
            code, error, fired, files = self.run(fault)
        except subprocess.TimeoutExpired:
            return self.complain(fault, "does not end")
        if not fired:
            return
        self.faults += 1
        lines = [line for line in error.splitlines() if not line.startswith("pupflow: note: ")]
        if self.case.hdf5 and fault.startswith("malloc") and error.startswith("HDF5-DIAG"):
            self.accounts += 1  # libhdf5 could not start, so nobody could ask it to be quiet
            lines = [line for line in lines if not line.startswith(("HDF5-DIAG", "  #", "    m"))]
        if self.case.hdf5 and fault.startswith("malloc") and code in (-6, -11):
            self.crashes += 1  # libhdf5's own: it goes on with what it could not allocate
        elif code not in allowed:
            self.complain(fault, f"exit code {code}: {error}")
        elif code != 0 and (len(lines) != 1 or not lines[0].startswith("pupflow: ")):
            self.complain(fault, f"exit code {code} with standard error {error!r}")
        if self.case.folder:
            return self.finish(fault)
        for name, data in files.items():
            if code != 0 and self.case.hdf5 and name.endswith(".unfinished"):
                continue  # what a recording flushed, or where libhdf5 ended the program
            if name not in self.reference:
                self.complain(fault, f"exit code {code}, left behind: {name}")
            elif data != self.reference[name] and not self.same_recording(name):
                self.complain(fault, f"exit code {code}, {name} differs")
        for name in self.reference.keys() - files.keys():
            if code == 0:
                self.complain(fault, f"exit code 0 without {name}")

    def same_recording(self, name):
        """HDF5 may place the same data otherwise after a write that it did again."""
        return name.endswith(".h5") and subprocess.run(
            [self.program, "verify", name], cwd=self.scratch / "work", capture_output=True
        ).returncode == 0

    def finish(self, fault):
        """The same command completes the folder."""
        code, error, _, files = self.run("read:0", again=True)
        if code != 0:
            return self.complain(fault, f"then without fault: exit code {code}: {error}")
        for name in files.keys() | self.reference.keys():
            if files.get(name) != self.reference.get(name):
                self.complain(fault, f"then without fault: {name} " +
                              ("is missing" if name not in files else
                               "is left over" if name not in self.reference else "differs"))


def main():
    program, shim, name = sys.argv[1:4]
    kinds = sys.argv[4:]
    trial = Trial(os.path.abspath(program), os.path.abspath(shim), CASES[name])
    for kind, allowed in CASES[name].kinds.items():
        if kinds and kind not in kinds:
            continue
        calls = trial.calls(kind)
        for call in calls:
            # This call alone, or all later ones too. Without any memory libhdf5 and Mesa crash.
            alone = kind == "malloc" and (trial.case.hdf5 or trial.case.drawn)
            for later in ("",) if alone else ("", "+"):
                trial.look(f"{kind}:{call}{later}", allowed | trial.case.codes)
    shutil.rmtree(trial.scratch)
    print(f"{name}: {trial.faults} faults, {trial.problems} problems; libhdf5: {trial.crashes} crashes, "
          f"{trial.accounts} errors in its own words")
    return trial.problems != 0


sys.exit(main())
