"""The demo's scene of avatars, which the clients own: a run with and without relay, and their table."""

from dataclasses import dataclass

import demo_network
from demo_run import DemoRun, RunFailed, progress
from demo_table import print_rows
from pose_error import best_delay, percentile, rows_at
from pose_record import ROW_FLOATS, PoseRecord, lever_distance, moving_bodies

SCENE = "avatars"
PARTS = 3
ARMS = ("on", "off")
TITLES = {"on": "MotorSynchronizer.relay", "off": "forwarded by Godot"}
SPARE_SECONDS = 40
# One in so many frames is compared.
FRAME_STEP = 3
# How far the delay of a frame may differ from the mean one, and the steps in which it is searched, in seconds. On an impaired
# network, the playback delay adapts.
DELAY_RANGE = 0.03
IMPAIRED_DELAY_RANGE = 0.25
DELAY_STEPS = (0.01, 0.001)


@dataclass
class Traffic:
    """Datagrams and bytes per second of a process."""

    sent_datagrams: float
    sent_bytes: float
    received_datagrams: float
    received_bytes: float

    @staticmethod
    def of(report):
        return Traffic(*(report[key] / report["seconds"] for key in Traffic.__dataclass_fields__))

    @staticmethod
    def mean(items):
        return Traffic(*(sum(getattr(item, key) for item in items) / len(items) for key in Traffic.__dataclass_fields__))

    @property
    def datagrams(self):
        return self.sent_datagrams + self.received_datagrams

    @property
    def bytes(self):
        return self.sent_bytes + self.received_bytes


@dataclass
class Figures:
    """Figures of a run; errors in millimeters, delay in milliseconds."""

    server: Traffic
    client: Traffic
    p50: float
    p99: float
    max: float
    delay: float


def run_avatars(engine, folder, options, relay):
    """Runs the scene with `relay` "on" or "off"; returns its Figures."""
    with DemoRun(engine, folder) as run:
        phase = f"relay {relay}: running a server and {options.clients} clients"
        progress(f"{phase} for {options.seconds} s ...")
        run.start_server(f"--scene={SCENE}", f"--relay={relay}", f"--seconds={options.seconds}", f"--clients={options.clients}")
        start_clients(run, options, options.seconds)
        run.wait(options.seconds + SPARE_SECONDS, lambda elapsed: progress(f"{phase},", f" {elapsed:.0f} s"))
        run.check_logs()
        progress(f"relay {relay}: comparing the clients' poses with the owners' ...")
        return evaluate(run, options)


def start_clients(run, options, seconds):
    """Starts all clients; with --window, the first one in a window."""
    for number in range(options.clients):
        window = 0 if number == 0 and options.window else None
        record = () if seconds else ("--record=",)
        run.start_client(f"--scene={SCENE}", *demo_network.client_arguments(options, number + 1), f"--seconds={seconds}", *record,
                         window=window)


def evaluate(run, options):
    """The figures of a finished run: errors pooled over all pairs of an owner and a client that shows its avatar."""
    reports = [client.report() for client in run.clients]
    errors, delays = [], []
    network_delay = demo_network.max_delay(options)
    delay_range = IMPAIRED_DELAY_RANGE if demo_network.describe(options) else DELAY_RANGE
    for owner, own in zip(run.clients, reports):
        truth = PoseRecord(owner.record_path, PARTS)
        moving = moving_bodies(truth)
        for viewer in run.clients:
            if viewer is not owner:
                shown = PoseRecord(f"{viewer.record_path}.{own['slot']}", PARTS)
                compare(truth, moving, shown, best_delay(truth, moving, shown, 0.5 + 2 * network_delay), delay_range, errors, delays)
    if not errors:
        raise RunFailed("no client showed an avatar of another")
    return Figures(Traffic.of(run.server.report()), Traffic.mean([Traffic.of(report) for report in reports]),
                   1000 * percentile(errors, 0.5), 1000 * percentile(errors, 0.99), 1000 * max(errors),
                   1000 * percentile(delays, 0.5))


def compare(truth, moving, shown, mean_delay, delay_range, errors, delays):
    """Appends the errors of the moving bodies and the delay of frames.

    The clocks of the owner and the client are the same, but the media time shown is not recorded: the delay of a frame is the
    one close to the mean delay at which its three bodies fit the owner's best.
    """
    for wall, rows in list(zip(shown.walls, shown.rows))[::FRAME_STEP]:
        best = None
        delay, span = mean_delay, delay_range
        for step in DELAY_STEPS:
            count = round(span / step)
            fits = [fit for fit in (fit_at(truth, moving, wall, rows, delay + step * i) for i in range(-count, count + 1)) if fit]
            if not fits:
                break
            best = min(fits, key=lambda fit: sum(fit.errors))
            delay, span = best.delay, step
        if best:
            errors += [best.errors[at // ROW_FLOATS] for at in best.moving]
            delays.append(best.delay)


@dataclass
class Fit:
    """The errors of the bodies of a frame, in meters, if it is `delay` seconds late; `moving` are the offsets of moving ones."""

    errors: list
    delay: float
    moving: list


def fit_at(truth, moving, wall, rows, delay):
    """The Fit of a frame at a delay; None if the owner recorded nothing at that time."""
    pose, index = rows_at(truth, truth.walls, wall - delay)
    if pose is None:
        return None
    return Fit([lever_distance(pose, rows, at) for at in range(0, PARTS * ROW_FLOATS, ROW_FLOATS)], delay, moving[index])


COLUMNS = (
    ("server datagrams/s", lambda f: f"{f.server.datagrams:.0f}"),
    ("kB/s", lambda f: f"{f.server.bytes / 1000:.1f}"),
    ("client received/s", lambda f: f"{f.client.received_datagrams:.0f}"),
    ("kB/s", lambda f: f"{f.client.received_bytes / 1000:.2f}"),
    ("client sent/s", lambda f: f"{f.client.sent_datagrams:.0f}"),
    ("kB/s", lambda f: f"{f.client.sent_bytes / 1000:.2f}"),
    ("error p50", lambda f: f"{f.p50:.1f} mm"),
    ("p99", lambda f: f"{f.p99:.1f} mm"),
    ("delay", lambda f: f"{f.delay:.0f} ms"),
)


def print_table(arms, options):
    """Prints the table, the meaning of its columns, and a one-sentence result."""
    print(f"{options.clients} avatars of {PARTS} bodies, each owned by a client, {options.seconds} s each")
    print_rows(COLUMNS, {TITLES[relay]: figures for relay, figures in arms.items()}, options)
    print("server: datagrams and bytes sent and received; client: the mean of all clients. By ENet's counters, without the 28 bytes")
    print("of IP and UDP headers per datagram.")
    print("error: distance between a client's and the owner's pose, for moving heads and hands; the largest of the center and three")
    print("points 0.25 m along the axes, at the delay that fits the frame's three bodies best.")
    print("delay: from the owner's frame to the client's, network included.")
    print()
    if len(arms) < 2:
        return
    relay, plain = arms["on"], arms["off"]
    print(f"Result: with relay, 1/{plain.server.datagrams / relay.server.datagrams:.1f} of the datagrams and "
          f"1/{plain.server.bytes / relay.server.bytes:.1f} of the bytes at the server; 99 % of the errors are within "
          f"{relay.p99:.1f} mm, {relay.delay:.0f} ms behind the owner.")


def json_rows(arms, options):
    """Rows in the format of tools/bench."""
    rows = []
    for relay, figures in arms.items():
        def add(case, value, unit, subject="ga_godot" if relay == "on" else "ga_godot_without_relay"):
            rows.append({"suite": "network", "case": case, "subject": subject, "n": options.clients, "value": value,
                         "unit": unit, "trace": "demo_" + SCENE, "loss": options.loss, "jitter": options.jitter,
                         "delay": options.delay})
        add("server_datagrams_per_second", figures.server.datagrams, "1/s")
        add("server_bytes_per_second", figures.server.bytes, "byte/s")
        add("client_received_datagrams_per_second", figures.client.received_datagrams, "1/s")
        add("client_received_bytes_per_second", figures.client.received_bytes, "byte/s")
        add("client_sent_datagrams_per_second", figures.client.sent_datagrams, "1/s")
        add("client_sent_bytes_per_second", figures.client.sent_bytes, "byte/s")
        add("error_p50", figures.p50, "mm")
        add("error_p99", figures.p99, "mm")
        add("error_max", figures.max, "mm")
        add("playback_delay", figures.delay, "ms")
    return rows
