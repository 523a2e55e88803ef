#!/usr/bin/env python3
"""The examples of docs/examples/ci are run: their shell lines, unchanged, in a repository with scenes and baselines.

A bundle is stood in for by an archive with the program. The first run must succeed, the second, with a changed scene, must fail in the
comparison; both must leave the report and the test results that the jobs upload. Then the files' keys are compared with those that GitHub
Actions and GitLab know. Exit code 1 with what was wrong; 77 (skipped) without python3-yaml, curl or xz.

Usage: ci_check.py POINSOT
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLES = ROOT / "docs" / "examples" / "ci"

# The keys that the examples may use, from GitHub's "Workflow syntax" and GitLab's "CI/CD YAML syntax reference".
GITHUB = {"": {"name", "on", "permissions", "jobs", "env", "concurrency"},
          "job": {"runs-on", "timeout-minutes", "steps", "env", "needs", "if", "container"},
          "step": {"name", "uses", "with", "run", "env", "if", "id", "shell", "working-directory"}}
GITLAB = {"image", "timeout", "before_script", "script", "after_script", "artifacts", "variables", "rules", "stage", "needs"}
ARTIFACTS = {"when", "expose_as", "paths", "reports", "name", "expire_in", "exclude"}


def make_bundle(program, folder):
    """An archive like the bundle: one folder that contains bin/poinsot and the scenes."""
    archive = folder / "poinsot-0-x86_64.tar.xz"
    with tarfile.open(archive, "w:xz", preset=0) as bundle:
        script = folder / "poinsot"
        script.write_text(f'#!/bin/sh\nexec "{program}" "$@"\n')
        script.chmod(0o755)
        bundle.add(script, "poinsot-0-x86_64/bin/poinsot")
    return archive.as_uri()


def make_repository(program, folder):
    (folder / "scenes").mkdir(parents=True)
    (folder / "results").mkdir()
    shutil.copy(ROOT / "scenes" / "sphere.toml", folder / "scenes")
    subprocess.run([program, "still", "scenes/sphere.toml", "--portable", "--size", "480x270", "-q", "-o", "results/sphere.png"],
                   cwd=folder, check=True)
    subprocess.run([program, "approve", "--all", "--results", "results", "--baselines", "baselines", "--why", "first", "-q"],
                   cwd=folder, check=True)
    shutil.rmtree(folder / "results")


def change_scene(folder):
    scene = folder / "scenes" / "sphere.toml"
    scene.write_text('theme = "dark"\n' + re.sub(r'^theme *=.*\n', '', scene.read_text(), flags=re.M))


def run_steps(steps, folder, environment):
    """Runs each step as a CI runner does; returns the exit code of the first that fails. Paths added to GITHUB_PATH hold for later steps."""
    path_file = pathlib.Path(environment["GITHUB_PATH"])
    for step in steps:
        path_file.touch()
        added = path_file.read_text().split()
        step_environment = {**environment, "PATH": ":".join([*reversed(added), environment["PATH"]])}
        done = subprocess.run(["bash", "-e", "-o", "pipefail", "-c", step], cwd=folder, env=step_environment, capture_output=True,
                              text=True)
        if done.returncode != 0:
            return done.returncode, done.stdout + done.stderr
        output = done.stdout
    return 0, output


def check_job(name, steps, uploads, program):
    with tempfile.TemporaryDirectory() as scratch:
        scratch = pathlib.Path(scratch)
        url = make_bundle(program, scratch)
        repository = scratch / "repository"
        make_repository(program, repository)
        for is_changed in (False, True):
            if is_changed:
                change_scene(repository)
            runner = scratch / f"runner{int(is_changed)}"
            runner.mkdir()
            environment = {**os.environ, "POINSOT_BUNDLE": url, "RUNNER_TEMP": str(runner), "CI_BUILDS_DIR": str(runner),
                           "GITHUB_PATH": str(runner / "path"), "GITHUB_STEP_SUMMARY": str(runner / "summary.md"),
                           "LANG": "C.UTF-8"}
            code, output = run_steps(steps, repository, environment)
            if code != int(is_changed):
                yield f"{name}: exit code {code}, not {int(is_changed)}: {output}"
            for path in uploads:
                if not (repository / path).exists():
                    yield f"{name}: {path} is uploaded, but was not written"
            if is_changed and name == "github.yml":
                if "::error file=baselines/sphere.png" not in output:
                    yield f"{name}: no annotation: {output}"
                if "| pixels | sphere | theme: light → dark" not in (runner / "summary.md").read_text():
                    yield f"{name}: no summary: {(runner / 'summary.md').read_text()}"
            shutil.rmtree(repository / "report", ignore_errors=True)
            shutil.rmtree(repository / "results", ignore_errors=True)


def unknown_keys(name, mapping, known):
    for key in mapping:
        if key not in known:
            yield f"{name}: unknown key {key}"


def check_github(yaml, program):
    workflow = yaml.safe_load((EXAMPLES / "github.yml").read_text())
    # YAML 1.1 reads `on` as a boolean.
    keys = {"on" if key is True else key for key in workflow}
    yield from unknown_keys("github.yml", keys, GITHUB[""])
    for job in workflow["jobs"].values():
        yield from unknown_keys("github.yml", job, GITHUB["job"])
        uploads = []
        for step in job["steps"]:
            yield from unknown_keys("github.yml", step, GITHUB["step"])
            if ("run" in step) == ("uses" in step):
                yield f"github.yml: a step has either run or uses: {step}"
            if step.get("uses", "").startswith("actions/upload-artifact@"):
                uploads = step["with"]["path"].split()
                if "always()" not in step.get("if", ""):
                    yield "github.yml: the report is uploaded only if nothing differs"
        yield from check_job("github.yml", [step["run"] for step in job["steps"] if "run" in step],
                             [*uploads, "report/index.html", "report/junit.xml"], program)


def check_gitlab(yaml, program):
    jobs = yaml.safe_load((EXAMPLES / "gitlab.yml").read_text())
    for job in jobs.values():
        yield from unknown_keys("gitlab.yml", job, GITLAB)
        yield from unknown_keys("gitlab.yml", job["artifacts"], ARTIFACTS)
        if job["artifacts"]["when"] != "always":
            yield "gitlab.yml: the report is kept only if nothing differs"
        # GitLab runs all lines in one shell. Packages are those of a bare Debian.
        lines = [line for line in job["before_script"] + job["script"] if not line.startswith("apt-get ")]
        uploads = [*job["artifacts"]["paths"], job["artifacts"]["reports"]["junit"], "report/index.html"]
        yield from check_job("gitlab.yml", ["\n".join(lines)], uploads, program)


def main():
    try:
        import yaml
    except ImportError:
        print("skipped: no python3-yaml")
        return 77
    if not (shutil.which("curl") and shutil.which("xz")):
        print("skipped: no curl or xz")
        return 77
    program = str(pathlib.Path(sys.argv[1]).resolve())
    faults = [*check_github(yaml, program), *check_gitlab(yaml, program)]
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
