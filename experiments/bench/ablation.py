#!/usr/bin/env python3
"""Back end x correction x particles on real logs and a simulated one, as the table of README.md.

Every cell is the median over the seeds: error (mean relation error, or RMSE of the position where
the truth is known), CPU seconds, peak memory. The baselines are plain GMapping and the paper read
literally (experiments/flags). A stopped study goes on where it was when given the same --work_dir.
"""
import argparse
import concurrent.futures
import itertools
import json
import pathlib
import statistics
import sys
import tempfile

import runs

BACKENDS = [("none", "-", ["--backend=none"])] + [
    (backend, correction, [f"--backend={backend}", f"--correction={correction}"])
    for backend, correction in itertools.product(("spa", "ceres"), ("pose", "trajectory"))]


def variants(particles):
    """(label, back end, correction, particles, flags)"""
    for name, label in (("gmapping", "plain GMapping"), ("paper", "paper, literally")):
        for count in (30, 5):
            yield (label, "none" if name == "gmapping" else "spa",
                   "-" if name == "gmapping" else "pose", count,
                   [f"--flagfile={runs.FLAGS / name}.flags", f"--particles={count}"])
    for (backend, correction, flags), count in itertools.product(BACKENDS, particles):
        yield "improved", backend, correction, count, [*flags, f"--particles={count}"]


def result_of(args, work, simulated, variant, log, seed):
    label, backend, correction, count, flags = variant
    name = f"{label}-{backend}-{correction}-{count}-{log}-{seed}".replace(" ", "_").replace(",", "")
    done = work / f"{name}.json"
    if not done.exists():
        result = runs.measure(args, log, [*flags, f"--seed={seed}"], work / name, simulated)
        done.with_suffix(".tmp").write_text(json.dumps(result))
        done.with_suffix(".tmp").rename(done)
        print(f"{name}: {result.get('error_m', float('nan')):.4f} m, {result['cpu_s']:.1f} s",
              file=sys.stderr)
    return json.loads(done.read_text())


def cell(results):
    errors = [r["error_m"] for r in results]
    spread = f" (to {max(errors):.4f})" if len(errors) > 1 else ""
    cpu_s = statistics.median(r["cpu_s"] for r in results)
    memory_mb = statistics.median(r["memory_mb"] for r in results)
    return f"{statistics.median(errors):.4f}{spread}<br>{cpu_s:.1f} s, {memory_mb:.0f} MB"


def table(args, work):
    simulated = work / "simulated"
    runs.simulate(args, simulated)
    rows = list(variants(args.particles))
    cells = {}
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        for row, log, seed in itertools.product(range(len(rows)), args.logs, args.seeds):
            cells[row, log, seed] = pool.submit(
                result_of, args, work, simulated, rows[row], log, seed)
    lines = [
        f"`{runs.command('ablation.py')}`, {runs.processor()}, "
        f"seeds {' '.join(map(str, args.seeds))}: median"
        f"{' (and worst)' if len(args.seeds) > 1 else ''} error in m, CPU time, peak memory.\n",
        f"| flags | back end | correction | particles | {' | '.join(args.logs)} |",
        "|---|---|---|---|" + "---|" * len(args.logs)]
    for k, (label, backend, correction, count, _) in enumerate(rows):
        values = [cell([cells[k, log, seed].result() for seed in args.seeds]) for log in args.logs]
        lines.append(f"| {label} | {backend} | {correction} | {count} | {' | '.join(values)} |")
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    runs.add_arguments(parser)
    parser.add_argument("--logs", nargs="+", default=["intel", "fr079", "aces", runs.SIMULATED])
    parser.add_argument("--seeds", nargs="+", type=int, default=[1, 2, 3])
    parser.add_argument("--particles", nargs="+", type=int, default=[1, 2, 5, 15, 30])
    parser.add_argument("--jobs", type=int, default=1, help="runs side by side; slows each down")
    parser.add_argument("--work_dir", type=pathlib.Path, help="keeps the runs")
    args = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        work = args.work_dir or pathlib.Path(folder)
        work.mkdir(parents=True, exist_ok=True)
        runs.replace_table(runs.ROOT / "README.md", "ablation", table(args, work))


if __name__ == "__main__":
    main()
