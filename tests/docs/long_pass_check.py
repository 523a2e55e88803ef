#!/usr/bin/env python3
"""The long pass (.ci/long) runs no step again that has passed on a commit, and all steps of another commit.

With steps of its own, in a repository of its own. Exit code 1 with what was wrong.
"""
import contextlib
import importlib.machinery
import importlib.util
import io
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
# Two tests, of which one fails as long as there is no file "mended".
CTEST = """#!/bin/sh
echo "$*" >> ../asked
case "$*" in *first*) ;; *) echo '1/2 Test #11: first ........   Passed    0.10 sec' ;; esac
[ -e ../mended ] && echo '2/2 Test #12: second .......   Passed    0.10 sec' && exit 0
echo '2/2 Test #12: second .......***Failed    0.10 sec'
exit 8
"""


def main():
    with tempfile.TemporaryDirectory() as scratch:
        scratch = pathlib.Path(scratch)
        root, programs = scratch / "repository", scratch / "programs"
        (root / ".ci").mkdir(parents=True)
        programs.mkdir()
        (programs / "ctest").write_text(CTEST)
        (programs / "ctest").chmod(0o755)
        (root / ".ci/setup").write_text("")
        (root / ".gitignore").write_text("/build/\n")
        os.environ.update(PATH=f"{programs}:{os.environ['PATH']}", GIT_AUTHOR_NAME="a", GIT_AUTHOR_EMAIL="a@b", GIT_COMMITTER_NAME="a",
                          GIT_COMMITTER_EMAIL="a@b", GIT_CONFIG_GLOBAL="/dev/null")

        def commit(name):
            (root / name).write_text(name)
            subprocess.run(["git", "add", "-A"], cwd=root, check=True)
            subprocess.run(["git", "commit", "-q", "-m", name], cwd=root, check=True)

        subprocess.run(["git", "init", "-q"], cwd=root, check=True)
        loader = importlib.machinery.SourceFileLoader("long_pass", str(ROOT / ".ci/long"))
        long_pass = importlib.util.module_from_spec(importlib.util.spec_from_loader("long_pass", loader))
        loader.exec_module(long_pass)
        long_pass.ROOT = root
        long_pass.STEPS = [("good", "a good step", "echo good >> ../ran"), ("bad", "a bad step", "echo bad >> ../ran; echo why; false | cat"),
                           ("tests", "some tests", "CTEST --preset slow")]

        def run(*words):
            sys.argv = ["long", *words]
            said = io.StringIO()
            with contextlib.redirect_stdout(said):
                code = long_pass.main()
            return code, said.getvalue(), (scratch / "ran").read_text().split(), (scratch / "asked").read_text().splitlines()

        commit("a")
        code, said, ran, asked = run()
        assert code == 1 and ran == ["good", "bad"] and asked == ["--preset slow"], (code, ran, asked)
        assert "| failed: why |" in said and "| 1 of 2 tests passed, second failed |" in said and "| passed |" in said, said
        (scratch / "mended").write_text("")
        code, said, ran, asked = run()
        assert code == 1 and ran == ["good", "bad", "bad"], (code, ran)
        assert len(asked) == 2 and "-E ^(first)$" in asked[1] and "| 2 of 2 tests passed |" in said, (asked, said)
        code, _, ran, asked = run("good", "tests")
        assert code == 0 and ran == ["good", "bad", "bad"] and len(asked) == 2, (code, ran, asked)
        commit("b")
        _, said, ran, asked = run()
        assert ran == ["good", "bad", "bad", "good", "bad"] and asked[2] == "--preset slow", (ran, asked)
        (root / "c").write_text("not committed")
        try:
            run()
        except SystemExit as refusal:
            assert "commit the changes first" in str(refusal), refusal
        else:
            raise AssertionError("changes without a commit have outcomes")


if __name__ == "__main__":
    main()
