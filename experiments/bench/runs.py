"""Runs of gmapping_spa on real logs, for front_end.py."""
import json
import os
import pathlib
import platform
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
FLAGS = ROOT / "experiments" / "flags"


def run(*words):
    return subprocess.run(words, check=True, capture_output=True, text=True).stdout


def processor():
    for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return platform.machine()


def command(script):
    """The command line to show: without folders, which differ from machine to machine."""
    words = [w for w in sys.argv[1:] if not w.startswith(("--bin", "--data", "--work_dir"))]
    return " ".join([f"experiments/bench/{script}", *words])


def add_arguments(parser):
    parser.add_argument("--data", type=pathlib.Path, default=pathlib.Path(
        os.environ.get("GMAPPING_SPA_DATA", ROOT.parent / "shared" / "data")),
        help="folder with carmen/ and relations/")
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build" / "bin")


def measure(args, log, flags, out):
    """One run: costs, and the errors against relations (m, deg)."""
    path = args.data / "carmen" / f"{log}.clf.gz"
    run(args.bin / "gmapping_spa", *flags, "--threads=1", f"--log={path}", f"--output_dir={out}")
    record = json.loads((out / "run.json").read_text())
    result = {
        "record": record,
        "cpu_s": record["resources"]["user_s"] + record["resources"]["system_s"],
        "memory_mb": record["resources"]["peak_memory_mb"],
    }
    relations = args.data / "relations" / f"{log}.relations.gz"
    if relations.exists():
        errors = json.loads(run(
            args.bin / "evaluate_relations", f"--relations={relations}",
            f"--trajectory={out / 'trajectory.tum'}"))
        result["error_m"] = errors["translation_m"]["mean"]
        result["median_m"] = errors["translation_m"]["median"]
        result["rotation_deg"] = errors["rotation_deg"]["mean"]
    return result


def replace_table(readme, name, table):
    begin, end = f"<!-- {name} begin -->", f"<!-- {name} end -->"
    text = readme.read_text()
    readme.write_text(f"{text[:text.index(begin)]}{begin}\n{table}\n{text[text.index(end):]}")
