#!/usr/bin/env python3
"""Checks completions in real shells, and manual pages with groff.

Usage: shells_check.py POINSOT WHAT     bash, zsh, fish: that shell; manual: every page
"""
import os
import pathlib
import pty
import re
import select
import subprocess
import sys
import tempfile
import time

# The text typed before the tabulator key, and words that must then be on the screen.
TYPED = [
    ("poinsot rec", ["poinsot recover"]),
    ("poinsot still --wid", ["--width-mm"]),
    ("poinsot render --theme colour-b", ["colour-blind"]),
    ("poinsot render --quality dr", ["draft"]),
    ("poinsot still --backend os", ["osmesa"]),
    ("poinsot still --set film.qual", ["film.quality="]),
    ("poinsot still --set film.quality=dr", ["film.quality=draft"]),
    ("poinsot still --set hidden=om", ["hidden=omitted"]),
    ("poinsot check tennis_r", ["tennis_racket"]),
    ("poinsot check my_own", ["my_own_scene.toml"]),
    ("poinsot list easi", ["easings"]),
    ("poinsot explain a_pict", ["a_picture.png"]),
]
DEADLINE_S = 20.0


class Shell:
    """A shell on its own terminal, in a folder with a scene and a picture."""

    def __init__(self, words, folder, environment):
        self.process, self.terminal = pty.fork()
        if self.process == 0:
            os.chdir(folder)
            os.execvpe(words[0], words, environment)
        self.screen = ""

    def read(self, seconds):
        end = time.monotonic() + seconds
        while (left := end - time.monotonic()) > 0 and select.select([self.terminal], [], [], left)[0]:
            try:
                self.screen += os.read(self.terminal, 65536).decode(errors="replace")
            except OSError:
                return

    def wait_for(self, wanted):
        end = time.monotonic() + DEADLINE_S
        while time.monotonic() < end:
            self.read(0.1)
            if all(word in plain(self.screen) for word in wanted):
                return True
        return False

    def send(self, text):
        self.screen = ""
        os.write(self.terminal, text.encode())


def plain(screen):
    """The visible text: without the terminal's control sequences."""
    return re.sub(r"\x1b\[[0-9;?<>=]*[ -/]*[@-~]|\x1b[()][A-Z0-9]|\x1b[=>]|\x1b\][^\x07]*\x07|[\r\x07]", "", screen)


def words_of(shell, folder, program):
    """The command that starts the shell with the completions and a unique prompt."""
    script = {"bash": "completion.bash", "zsh": "completion.zsh", "fish": "completion.fish"}[shell]
    text = subprocess.run([program, "list", script], check=True, capture_output=True, text=True).stdout
    if shell == "bash":
        (folder / "rc").write_text(text + "\nPS1='READY> '\nbind 'set enable-bracketed-paste off'\n")
        return ["bash", "--noprofile", "--rcfile", str(folder / "rc"), "-i"]
    if shell == "zsh":
        functions = folder / "functions"
        functions.mkdir()
        (functions / "_poinsot").write_text(text)
        (folder / ".zshrc").write_text(f"fpath=({functions} $fpath)\nautoload -U compinit\ncompinit -u -d {folder}/dump\nPS1='READY> '\nunset zle_bracketed_paste\n")
        return ["zsh", "-i"]
    (folder / "config").mkdir()
    (folder / "config" / "fish").mkdir()
    (folder / "config" / "fish" / "config.fish").write_text(
        text + "\nfunction fish_prompt\n    echo -n 'READY> '\nend\nfunction fish_greeting\nend\nset -g fish_autosuggestion_enabled 0\n")
    return ["fish", "-i"]


def shell_findings(shell, program):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "my_own_scene.toml").write_text("")
        (folder / "a_picture.png").write_text("")
        environment = {"PATH": f"{pathlib.Path(program).parent}:/usr/bin:/bin", "HOME": name, "ZDOTDIR": name, "TERM": "dumb",
                       "XDG_CONFIG_HOME": f"{name}/config", "XDG_DATA_HOME": f"{name}/data", "LANG": "C.UTF-8"}
        if shell == "fish":
            environment["TERM"] = "xterm"
        words = words_of(shell, folder, program)
        for typed, wanted in TYPED:
            running = Shell(words, folder, environment)
            if not running.wait_for(["READY>"]):
                yield f"{shell} gave no prompt: {plain(running.screen)!r}"
                return
            running.read(0.3)
            running.send(typed + "\t")
            if not running.wait_for(wanted):
                yield f"{shell}: {typed!r} and the tabulator key: no {wanted} in {plain(running.screen)!r}"
            os.close(running.terminal)
            os.kill(running.process, 9)
            os.waitpid(running.process, 0)


def manual_findings(program):
    listed = subprocess.run([program, "list", "documents"], check=True, capture_output=True, text=True).stdout
    pages = re.findall(r"^poinsot\S*\.[15]", listed, re.M)
    commands = re.findall(r"^  (\w+)  ", subprocess.run([program, "--help"], capture_output=True, text=True).stdout, re.M)
    for command in commands:
        help_text = subprocess.run([program, command, "--help"], check=True, capture_output=True, text=True).stdout
        if f"poinsot-{command}.1" not in pages:
            yield f"no manual page of {command}"
        if not re.search(r"\nExamples:\n(  poinsot %s.*\n      \S.*\n){2}$" % command, help_text):
            yield f"poinsot {command} --help does not end with two examples"
        if " TEXT" in help_text:
            yield f"poinsot {command} --help says TEXT where it should say what an option takes"
    for page in pages:
        text = subprocess.run([program, "list", page], check=True, capture_output=True).stdout
        set_ = subprocess.run(["groff", "-man", "-ww", "-Tutf8", "-Kutf8", "-P-cbou"], input=text, capture_output=True)
        if set_.returncode or set_.stderr:
            yield f"{page}: groff says {set_.stderr.decode().strip()}"
        for flag in re.findall(rb"^\\fB(--\S+?)\\fR", text.replace(rb"\-", b"-"), re.M):
            if flag not in set_.stdout.replace("−".encode(), b"-"):
                yield f"{page}: {flag.decode()} is not on the page"
    if len(commands) < 12:
        yield f"only {len(commands)} commands: {commands}"


if __name__ == "__main__":
    wrong = list(manual_findings(sys.argv[1]) if sys.argv[2] == "manual" else shell_findings(sys.argv[2], sys.argv[1]))
    print("\n".join(wrong))
    sys.exit(1 if wrong else 0)
