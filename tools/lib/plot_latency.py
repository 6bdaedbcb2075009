"""Plots the cost of each method over its playback delay: plot_latency.py ROWS.json PLOT.png

The rows are those of tools/bench network --latency-plot: baselines at fixed rates, ga_godot at several maximum latencies.
One panel per trace, both axes logarithmic. Labels give the error of each point.
"""

import sys

from plot_rate_distortion import KINDS as TOLERANCE_KINDS, draw_line, finish_axes, plot

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
    for kind in KINDS:
        prefix, _, color, _ = kind
        line = lines[prefix]
        ours = prefix == "ga_godot"
        draw_line(axes, line, kind)
        if prefix != "paper_motor_float32_":
            for delay, cost, p99 in line:
                label = f"{p99:.1f} mm" if p99 < 10 else f"{p99:.0f} mm"
                axes.annotate(label, (delay, cost), xytext=(0, -8 if ours else 7), textcoords="offset points", color=color,
                              fontsize=8.5, ha="center", va="top" if ours else "bottom")
    finish_axes(axes, title)


if __name__ == "__main__":
    plot(*sys.argv[1:], curves, draw_panel, "median playback delay, ms")
