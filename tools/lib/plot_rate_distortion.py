"""Plots the cost of each method over its error: plot_rate_distortion.py ROWS.json PLOT.png

The rows are those of tools/bench network --rate-distortion: baselines at fixed rates, ga_godot at several tolerances.
One panel per trace, both axes logarithmic.
"""

import json
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter  # noqa: E402

INK = "#1f2933"
FAINT = "#d9dee4"
# Prefix of the subjects, name in the legend, color, marker.
KINDS = (("pqs_float32_", "fixed rate: float32 position, quaternion, scale", "#c8553d", "s"),
         ("paper_motor_float32_", "fixed rate: GA-Unity's float32 motors", "#7d8a97", "^"),
         ("ga_godot", "GA-Godot, for tolerances", "#0b7285", "o"))
# Smaller errors, in mm, are rounding: the method sent every sample.
MIN_ERROR = 0.3
# Labels to draw; the others can be inferred.
LABELED = {"1 mm", "2 mm", "5 mm", "20 mm"} | {f"{rate} Hz" for rate in (5, 10, 20, 30, 60)}
COLUMNS = 2


def curves(rows, trace):
    """{prefix of the subjects: [(p99 in mm, B/s per body, label)]} of a trace, by ascending cost."""
    points = {}
    for row in rows:
        if row["trace"] == trace and row["case"] in ("error_p99", "bytes_per_second_per_body"):
            points.setdefault((row["subject"], row.get("tolerance_mm")), {})[row["case"]] = row["value"]
    found = {prefix: [] for prefix, *_ in KINDS}
    for (subject, tolerance), values in points.items():
        prefix = next(prefix for prefix, *_ in KINDS if subject.startswith(prefix))
        label = f"{tolerance:g} mm" if tolerance else subject[len(prefix):].replace("hz", " Hz") if prefix.startswith("pqs") else ""
        if values["error_p99"] is not None and values["error_p99"] >= MIN_ERROR:
            found[prefix].append((values["error_p99"], values["bytes_per_second_per_body"], label))
    return {prefix: sorted(line, key=lambda point: point[1]) for prefix, line in found.items()}


def draw_line(axes, line, kind):
    """Draws the curve of a kind through points that begin with x and y."""
    prefix, name, color, marker = kind
    ours = prefix == "ga_godot"
    axes.plot([point[0] for point in line], [point[1] for point in line], color=color, marker=marker, label=name,
              linewidth=2.4 if ours else 1.6, markersize=6.5 if ours else 5, markeredgecolor="white", markeredgewidth=0.8,
              zorder=4 if ours else 3)


def draw_panel(axes, lines, title):
    """Draws the curves of one trace."""
    for kind in KINDS:
        prefix, _, color, _ = kind
        line = lines[prefix]
        ours = prefix == "ga_godot"
        draw_line(axes, line, kind)
        for index, (p99, cost, label) in enumerate(line):
            if label in LABELED:
                # Ours below the curve, unless it bends back there.
                below = ours and not (index > 0 and line[index - 1][0] < p99)
                axes.annotate(label, (p99, cost), xytext=(-3, -6) if below else (7, 1), textcoords="offset points", color=color,
                              fontsize=8.5, ha="right" if below else "left", va="top" if below else "bottom")
    finish_axes(axes, title)


def finish_axes(axes, title):
    """Sets the scales and the style of a panel."""
    axes.set_title(title, loc="left", fontsize=11, color=INK, pad=8)
    axes.set_xscale("log")
    axes.set_yscale("log")
    plain = FuncFormatter(lambda value, _: f"{value:g}")
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(LogLocator(subs=(1, 2, 5)))
        axis.set_major_formatter(plain)
        axis.set_minor_formatter(NullFormatter())
    axes.grid(True, which="major", color=FAINT, linewidth=0.8)
    axes.tick_params(which="both", length=0, labelcolor=INK, labelsize=9, labelleft=True)
    for spine in axes.spines.values():
        spine.set_visible(False)
    axes.margins(x=0.1, y=0.08)


def titles(rows):
    """{trace: title}, in the order of the rows."""
    counts = {row["trace"]: row["n"] for row in rows}
    return {trace: f"{trace}  ({count:,} {'body' if count == 1 else 'bodies'})" for trace, count in counts.items()}


def new_figure(panel_count):
    """A figure with this many panels, and its grid of axes."""
    columns = min(COLUMNS, panel_count)
    panel_rows = -(-panel_count // columns)
    figure, grid = plt.subplots(panel_rows, columns, figsize=(5.6 * columns, 4.1 * panel_rows + 0.9), squeeze=False, sharey=True)
    for axes in grid.flat[panel_count:]:
        axes.set_visible(False)
    return figure, grid


def save_figure(figure, grid, x_label, path):
    """Adds the labels and the legend to a figure and saves it."""
    for axes in grid[:, 0]:
        axes.set_ylabel("bytes per second and body", color=INK)
    for axes in grid[-1]:
        axes.set_xlabel(x_label, color=INK)
    handles, names = grid.flat[0].get_legend_handles_labels()
    figure.legend(handles[::-1], names[::-1], loc="upper left", ncols=3, frameon=False, fontsize=9.5, labelcolor=INK,
                  bbox_to_anchor=(0.055, 0.995), handlelength=1.6, columnspacing=1.8)
    figure.tight_layout(rect=(0, 0, 1, 0.955), w_pad=2.5, h_pad=2.0)
    figure.savefig(path, dpi=110, facecolor="white", metadata={"Software": None})


def plot(rows_path, plot_path, find_curves, draw, x_label):
    """Reads the rows and saves a plot with a panel per trace: draw(axes, find_curves(rows, trace), title)."""
    with open(rows_path, encoding="utf-8") as file:
        rows = json.load(file)["rows"]
    panels = titles(rows)
    figure, grid = new_figure(len(panels))
    for axes, (trace, title) in zip(grid.flat, panels.items()):
        draw(axes, find_curves(rows, trace), title)
    save_figure(figure, grid, x_label, plot_path)


if __name__ == "__main__":
    plot(*sys.argv[1:], curves, draw_panel, "error, 99th percentile of moving samples, mm")
