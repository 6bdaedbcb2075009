"""The demo's figures as a table and as rows for JSON."""

import demo_network

SUBJECTS = {"motors": "ga_godot", "synchronizer": "multiplayer_synchronizer"}
TITLES = {"motors": "MotorSynchronizer", "synchronizer": "MultiplayerSynchronizer"}
COLUMNS = (
    ("kB/s", lambda f: f"{f['bytes_per_second'] / 1000:.1f}"),
    ("packets/s", lambda f: f"{f['packets_per_second']:.0f}"),
    ("B/s per moving cube", lambda f: f"{f['bytes_per_second'] / max(f['moving'], 1):.0f}"),
    ("error p50", lambda f: f"{f['p50']:.1f} mm"),
    ("p99", lambda f: f"{f['p99']:.1f} mm"),
    ("max", lambda f: f"{f['max']:.1f} mm"),
    ("at rest p99", lambda f: "-" if f["rest_p99"] is None else f"{f['rest_p99']:.1f} mm"),
    ("delay", lambda f: f"{f['delay']:.0f} ms"),
)


def print_rows(columns, figures_by_title, options):
    """Prints the impairment of the network, if any, and a table with a row per title. `columns` are (title, text of figures)."""
    network = demo_network.describe(options)
    if network:
        print(f"network, each way: {network}")
    print()
    rows = [["", *(title for title, _ in columns)]]
    rows += [[title, *(cell(figures) for _, cell in columns)] for title, figures in figures_by_title.items()]
    widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
    for row in rows:
        cells = [text.rjust(width) for text, width in zip(row[1:], widths[1:])]
        print("  ".join([row[0].ljust(widths[0]), *cells]).rstrip())
    print()


def print_table(arms, options):
    """Prints the table, the meaning of its columns, and a one-sentence result."""
    motors, synchronizer = arms["motors"], arms["synchronizer"]
    print(f"{options.cubes} cubes, {motors['moving']:.0f} of them moving on average, {options.clients} clients, "
          f"{options.seconds} s each")
    print_rows(COLUMNS, {TITLES[method]: figures for method, figures in arms.items()}, options)
    print("kB/s, packets/s: sent to one client, without the 28 bytes of IP and UDP headers per packet; by ENet's counters, or, if")
    print("the network is impaired, by the proxy's, before losses.")
    print("error: distance between the client's and the server's pose at the same media time, for moving cubes; the largest of the")
    print("center and three points 0.25 m along the axes. MultiplayerSynchronizer has no media time: the constant delay that")
    print("minimizes its mean error is removed.")
    print()
    ratio = synchronizer["bytes_per_second"] / motors["bytes_per_second"]
    print(f"Result: 1/{ratio:.1f} of MultiplayerSynchronizer's bytes; 99 % of the errors are within "
          f"{motors['p99']:.1f} mm, {motors['delay']:.0f} ms behind the server.")


def json_rows(arms, options):
    """Rows in the format of tools/bench."""
    rows = []
    for method, figures in arms.items():
        def add(case, value, unit, subject=SUBJECTS[method]):
            rows.append({"suite": "network", "case": case, "subject": subject, "n": options.cubes, "value": value,
                         "unit": unit, "trace": "demo_" + options.scene, "loss": options.loss, "jitter": options.jitter,
                         "delay": options.delay})
        add("bytes_per_second", figures["bytes_per_second"], "byte/s")
        add("bytes_per_second_per_body", figures["bytes_per_second"] / options.cubes, "byte/s")
        add("packets_per_second", figures["packets_per_second"], "1/s")
        add("error_p50", figures["p50"], "mm")
        add("error_p99", figures["p99"], "mm")
        add("error_max", figures["max"], "mm")
        if figures["rest_p99"] is not None:
            add("error_at_rest_p99", figures["rest_p99"], "mm")
        add("playback_delay", figures["delay"], "ms")
    return rows
