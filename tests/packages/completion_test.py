"""Types into an interactive shell on a terminal of its own, completes by Tab, and looks at the words
that a command gets then. usage: completion_test.py PROGRAM bash|zsh"""
import os
import pty
import select
import subprocess
import sys
import tempfile
import time

# What is typed before Tab, and the words after it.
CASES = [
    ("ren", ["render"]),
    ("doc", ["doctor"]),
    ("run --csv out.csv --rec", ["run", "--csv", "out.csv", "--record"]),
    ("run --set alp", ["run", "--set", "alpha="]),
    ("sweep --vary gra", ["sweep", "--vary", "gravity="]),
    ("render --color-by felt", ["render", "--color-by", "felt_tb"]),
    ("live crit", ["live", "critical"]),
    ("run my_sc", ["run", "my_scene.toml"]),
]
SHELLS = {
    "bash": (["bash", "--norc", "--noprofile", "-i"], ["source _pupflow"]),
    "zsh": (["zsh", "-f", "-i"], ["fpath=($PWD $fpath)", "autoload -Uz compinit", "compinit -D -u"]),
}
PATIENCE = 60  # seconds


class Terminal:
    def __init__(self, command, folder):
        self.seen = b""
        self.process, self.terminal = pty.fork()
        if self.process == 0:
            os.chdir(folder)
            os.environ.update(TERM="dumb", PS1="", HOME=folder)
            os.execvp(command[0], command)

    def type(self, text):
        os.write(self.terminal, text.encode())

    def wait_for(self, path):
        """Waits until the shell has made the file, and takes it away."""
        end = time.monotonic() + PATIENCE
        while not os.path.exists(path):
            if time.monotonic() > end:
                sys.exit("the shell does not answer; it printed:\n" + self.seen.decode(errors="replace"))
            if select.select([self.terminal], [], [], 0.02)[0]:
                self.seen += os.read(self.terminal, 65536)
        with open(path, encoding="utf-8") as file:
            text = file.read()
        os.remove(path)
        return text


def words_after(program, shell):
    """The words that `pupflow` gets in each case."""
    command, setup = SHELLS[shell]
    with tempfile.TemporaryDirectory() as folder:
        with open(os.path.join(folder, "_pupflow"), "wb") as file:
            subprocess.run([program, "help", "--format", shell], stdout=file, check=True)
        open(os.path.join(folder, "my_scene.toml"), "w").close()
        answer = os.path.join(folder, "answer")
        # In place of the program: a function that writes its words, a line each.
        setup = setup + ['pupflow() { printf "%s\\n" "$@" >unfinished; mv unfinished answer; }']
        terminal = Terminal(command, folder)
        for line in setup + ["pupflow ready"]:
            terminal.type(line + "\n")
        terminal.wait_for(answer)
        for typed, _ in CASES:
            terminal.type("pupflow " + typed + "\t\n")
            yield terminal.wait_for(answer).splitlines()
        terminal.type("exit\n")
        os.close(terminal.terminal)
        os.waitpid(terminal.process, 0)


def main():
    failed = False
    for (typed, expected), words in zip(CASES, list(words_after(*sys.argv[1:]))):
        if words != expected:
            print(f"pupflow {typed}<Tab> became {words}, not {expected}")
            failed = True
    sys.exit(failed)


main()
