"""The demo's scene in which each client owns an avatar."""

import os

import demo
import demo_avatars
from checks import expect, wait_until
from demo_run import START_SECONDS

# Bounds in millimeters and milliseconds, for the default settings of MotorSynchronizer.
MAX_P99 = 10.0
MAX_DELAY = 250.0


def clients_own_avatars_with_and_without_relay(run):
    options = demo.parse_arguments(["--scene", "avatars", "--clients", "4", "--seconds", "4"])
    arms = {}
    for relay in demo_avatars.ARMS:
        folder = os.path.join(run.folder, relay)
        os.mkdir(folder)
        figures = arms[relay] = demo_avatars.run_avatars(run.engine, folder, options, relay)
        expect(figures.p99 < MAX_P99, f"relay {relay}: the 99th percentile of the errors is {figures.p99:.1f} mm")
        expect(figures.delay < MAX_DELAY, f"relay {relay}: a delay of {figures.delay:.0f} ms")
    demo_avatars.print_table(arms, options)
    on, off = arms["on"], arms["off"]
    expect(on.server.datagrams < 0.7 * off.server.datagrams,
           f"with relay {on.server.datagrams:.0f} datagrams/s at the server, without {off.server.datagrams:.0f}")
    expect(on.server.bytes < 0.8 * off.server.bytes,
           f"with relay {on.server.bytes:.0f} bytes/s at the server, without {off.server.bytes:.0f}")


def client_changes_to_the_scene_of_the_server(run):
    run.start_server("--scene=avatars", "--clients=2", "--seconds=1", "--record=")
    clients = [run.start_client("--record="), run.start_client("--scene=avatars", "--record=")]
    run.wait(START_SECONDS)
    run.check_logs()
    for client in clients:
        expect("scene avatars" in client.log(), f"the client's last line: {client.last_line()}")
        expect(client.report()["received_datagrams"] > 0, "a client received nothing")
    run.clients.clear()
    run.start_server("--cubes=5", "--quit-when-empty=on", "--record=")
    lost = run.start_client("--scene=avatars", "--leave-after=0.2", "--record=")
    wait_until(lambda: not lost.is_running(), START_SECONDS, "the client did not leave")
    expect("scene cubes, 5 cubes" in lost.log(), f"the client's last line: {lost.last_line()}")
    lost.check_log()


CASES = (
    clients_own_avatars_with_and_without_relay,
    client_changes_to_the_scene_of_the_server,
)
