# SPDX-License-Identifier: BSD-3-Clause
"""The report as one HTML page that needs no other file and no network."""
import base64
import pathlib

import jinja2
from flags import as_text

from . import maps, plots, provenance, table

HERE = pathlib.Path(__file__).resolve().parent


def data_uri(content, kind):
    return f"data:{kind};base64,{base64.b64encode(content).decode()}"


def render(all_measured, all_tables, findings, scores, binaries, quick):
    """all_tables: tables.tables() of each study; findings: verdicts.Findings or None."""
    title = findings.title if findings else ", ".join(m.study.title for m in all_measured)
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(HERE), autoescape=True, trim_blocks=True, lstrip_blocks=True,
        undefined=jinja2.StrictUndefined)
    environment.filters.update(text=table.text, sort_value=table.sort_value)
    return environment.get_template("template.html").render(
        title=title,
        warnings=provenance.warnings(all_measured, quick),
        facts=provenance.facts(all_measured, binaries),
        findings=findings,
        studies=[_study(measured, tables, scores)
                 for measured, tables in zip(all_measured, all_tables)])


def _study(measured, tables, scores):
    study = measured.study
    return {
        "name": study.name,
        "title": study.title,
        "description": study.description,
        "design": _design(study),
        "tables": tables,
        "failures": [(r.run.configuration.label(), r.run.seed, r.outcome["error"])
                     for r in measured.failed],
        "plots": [(title, text, data_uri(svg.encode(), "image/svg+xml"))
                  for title, text, svg in plots.plots(measured)],
        "galleries": [_gallery(g) for g in maps.galleries(measured, scores)],
    }


def _design(study):
    """(name, values) of what the study varies."""
    axes = {}
    for config in study.configurations:
        for name, value in config.coordinates().items():
            axes.setdefault(name, {})[value] = None
    return [(name, ", ".join(map(as_text, values))) for name, values in axes.items() if
            list(values) != [""]] + [
        ("seeds", ", ".join(map(str, study.seeds))),
        ("runs", f"{len(study.configurations)} configurations x {len(study.seeds)} seeds = "
                 f"{len(study.runs)}")]


def _gallery(gallery):
    return {
        "title": gallery.title, "caption": gallery.caption, "columns": gallery.columns,
        "rows": [(name, [(p.text, p.alt, data_uri(p.png, "image/png") if p.png else None)
                         for p in panels]) for name, panels in gallery.rows]}
