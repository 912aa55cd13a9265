# SPDX-License-Identifier: BSD-3-Clause
"""Where the numbers come from: versions, commit, binaries, studies, and what is amiss."""
import hashlib
import pathlib
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[3]


def sha256(file):
    return hashlib.sha256(file.read_bytes()).hexdigest()


def commit():
    """Of the repository that this file is in, None outside of one."""
    try:
        head, changes = (subprocess.run(
            ["git", "-C", ROOT, *words], check=True, capture_output=True, text=True).stdout.strip()
            for words in (["rev-parse", "HEAD"], ["status", "--porcelain", "--untracked-files=no"]))
    except (OSError, subprocess.CalledProcessError):
        return None
    return f"{head}, with changes" if changes else head


def facts(all_measured, binaries):
    """(name, value) for the head of the page."""
    results = [r for measured in all_measured for r in measured.results]
    found = [("version", ", ".join(versions(all_measured)) or "no run yet")]
    if commit():
        found.append(("commit", commit()))
    found += [(f"SHA-256 of {binary.name}", sha256(binary))
              for binary in (binaries / "gmapping_spa", binaries / "simulate")
              if binary.is_file()]
    found += [(f"SHA-256 of {m.study.path.name}", sha256(m.study.path)) for m in all_measured]
    runs = {r.run.id for r in results}
    logs = {r.outcome["log_sha256"] for r in results} - {None}
    found.append(("runs", f"{len(runs)} on {len(logs)} logs; the table of runs at the end of each "
                  "study has the SHA-256 of every log and the command line of every run"))
    processors = sorted({r.outcome["processor"] for r in results if r.outcome.get("processor")})
    if processors:
        found.append(("processor", ", ".join(processors)))
    return found


def versions(all_measured):
    return sorted({r.outcome["version"] for m in all_measured for r in m.results
                   if r.outcome.get("version")})


def warnings(all_measured, quick):
    found = []
    if quick:
        found.append("This is the quick version, which shows that everything runs: too few and too "
                     "short runs to conclude anything.")
    if len(versions(all_measured)) > 1:
        found.append(f"Runs of different versions are mixed: {', '.join(versions(all_measured))}.")
    for measured in all_measured:
        total = len(measured.study.runs)
        if measured.missing:
            found.append(f"{measured.study.title}: {len(measured.missing)} of {total} runs are "
                         "missing; the numbers are of the others.")
        if measured.failed:
            found.append(f"{measured.study.title}: {len(measured.failed)} of {total} runs failed; "
                         "they count as the worst in every test.")
    return found
