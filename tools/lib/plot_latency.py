"""Plots the cost of each method over its playback delay: plot_latency.py ROWS.json PLOT.png

The rows are those of tools/bench network --latency-plot: baselines at fixed rates, ga_godot at several maximum latencies.
One panel per trace, both axes logarithmic. Labels give the error of each point.
"""

import json
import sys

from plot_rate_distortion import KINDS as TOLERANCE_KINDS, finish_axes, new_figure, save_figure, titles

KINDS = TOLERANCE_KINDS[:-1] + (("ga_godot", "GA-Godot, for latencies", *TOLERANCE_KINDS[-1][2:]),)
CASES = ("error_p99", "bytes_per_second_per_body", "playback_delay_median")


def curves(rows, trace):
    """{prefix of the subjects: [(delay in ms, B/s per body, p99 in mm)]} of a trace, by ascending delay."""
    points = {}
    for row in rows:
        if row["trace"] == trace and row["case"] in CASES:
            points.setdefault((row["subject"], row.get("latency_ms")), {})[row["case"]] = row["value"]
    found = {prefix: [] for prefix, *_ in KINDS}
    for (subject, _), values in points.items():
        prefix = next(prefix for prefix, *_ in KINDS if subject.startswith(prefix))
        if values["error_p99"] is not None:
            found[prefix].append((values["playback_delay_median"], values["bytes_per_second_per_body"], values["error_p99"]))
    return {prefix: cheapest_at_each_delay(line) for prefix, line in found.items()}


def cheapest_at_each_delay(line):
    """The points of a line by ascending delay, without those that cost more at the same delay."""
    cheapest = {}
    for point in sorted(line):
        cheapest.setdefault(round(point[0]), point)
    return list(cheapest.values())


def draw_panel(axes, lines, title):
    """Draws the curves of one trace."""
    for prefix, name, color, marker in KINDS:
        line = lines[prefix]
        ours = prefix == "ga_godot"
        axes.plot([delay for delay, _, _ in line], [cost for _, cost, _ in line], color=color, marker=marker, label=name,
                  linewidth=2.4 if ours else 1.6, markersize=6.5 if ours else 5, markeredgecolor="white", markeredgewidth=0.8,
                  zorder=4 if ours else 3)
        if prefix != "paper_motor_float32_":
            for delay, cost, p99 in line:
                label = f"{p99:.1f} mm" if p99 < 10 else f"{p99:.0f} mm"
                axes.annotate(label, (delay, cost), xytext=(0, -8 if ours else 7), textcoords="offset points", color=color,
                              fontsize=8.5, ha="center", va="top" if ours else "bottom")
    finish_axes(axes, title)


def main(rows_path, plot_path):
    """Reads the rows and saves the plot."""
    with open(rows_path, encoding="utf-8") as file:
        rows = json.load(file)["rows"]
    panels = titles(rows)
    figure, grid = new_figure(len(panels))
    for axes, (trace, title) in zip(grid.flat, panels.items()):
        draw_panel(axes, curves(rows, trace), title)
    save_figure(figure, grid, "median playback delay, ms", plot_path)


if __name__ == "__main__":
    main(*sys.argv[1:])
