"""One measured run of the demo: a scene, replicated to the clients by one method."""

import demo_network
from demo_run import DemoRun, RunFailed, progress
from pose_error import ErrorSummary, compare_by_tick, compare_by_wall_clock
from pose_record import PoseRecord, moving_bodies

# By scene.
CUBES = {"cubes": 250, "push": 901}
METHODS = ("motors", "synchronizer")
SPARE_SECONDS = 40


def run_arm(engine, folder, options, method):
    """Runs the scene with one method; returns its figures."""
    with DemoRun(engine, folder) as run:
        progress(f"{method}: running a server and {options.clients} clients for {options.seconds} s ...")
        run.start_server(f"--method={method}", f"--scene={options.scene}", f"--cubes={options.cubes}",
                         f"--seconds={options.seconds}", f"--clients={options.clients}")
        for number in range(options.clients):
            run.start_client(*demo_network.client_arguments(options, number + 1), f"--seconds={options.seconds}",
                             window=number if options.window else None)
        run.wait(options.seconds + SPARE_SECONDS,
                 lambda elapsed: progress(f"{method}: running a server and {options.clients} clients,", f" {elapsed:.0f} s"))
        run.check_logs()
        progress(f"{method}: comparing the clients' poses with the server's ...")
        return evaluate(run, options, method)


def evaluate(run, options, method):
    """The figures of a finished run: errors pooled over the clients, means of the rest."""
    server = PoseRecord(run.server.record_path, options.cubes)
    moving = moving_bodies(server)
    errors = ErrorSummary()
    reports = [client.report() for client in run.clients]
    for client in run.clients:
        shown = PoseRecord(client.record_path, options.cubes)
        if method == "motors":
            errors.merge(compare_by_tick(server, moving, shown))
        else:
            errors.merge(compare_by_wall_clock(server, moving, shown, demo_network.max_delay(options)))
    figures = errors.figures()
    if figures["p99"] is None:
        raise RunFailed(f"{method}: no client showed a moving cube")
    moving_count = sum(map(len, moving)) / max(1, len(moving))
    seconds = sum(report["seconds"] for report in reports)
    figures.update({
        "bytes_per_second": sum(report["bytes"] for report in reports) / seconds,
        "packets_per_second": sum(report["packets"] for report in reports) / seconds,
        "moving": moving_count,
        "late": sum(report["late"] for report in reports),
    })
    return figures
