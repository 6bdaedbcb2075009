"""Sessions over an unimpaired network, and how they end. Each case is a function that takes a DemoRun."""

import re
import signal
import time

from checks import expect, expect_errors_within, expect_good_network_errors, expect_same_end, server_record, wait_until
from demo_run import START_SECONDS
from pose_error import rows_at
from pose_record import PoseRecord, ROW_FLOATS, lever_distance


def moving_cubes_match_the_server(run):
    run.start_server("--cubes=250", "--seconds=4", "--clients=2")
    clients = [run.start_client(), run.start_client("--autopilot=circle")]
    run.wait(30)
    run.check_logs()
    for client in clients:
        samples = expect_good_network_errors(run, client, 250)
        expect(samples > 10000, f"only {samples} samples of moving cubes")
        report = client.report()
        expect(report["rejected"] == 0, f"{report['rejected']} datagrams rejected")
        expect(report["bytes"] / report["seconds"] < 12000, f"{report['bytes'] / report['seconds']:.0f} bytes per second")


def late_joiner_gets_the_snapshot_and_a_killed_client_affects_no_other(run):
    run.start_server("--cubes=80", "--seconds=6", "--clients=2", "--scripted-motion=off")
    first = run.start_client()
    killed = run.start_client("--record=")
    run.server.wait_for_line("The scene begins", START_SECONDS)
    time.sleep(1.5)
    killed.kill()
    time.sleep(1.5)
    late = run.start_client()
    run.clients.remove(killed)
    run.wait(30)
    run.check_logs()
    expect("Player 2 has joined." in run.server.log(), "the client to kill never joined")
    for client in (first, late):
        expect_same_end(run, client, 80)
    expect_good_network_errors(run, first, 80)
    expect(PoseRecord(late.record_path, 80).ticks[0] > PoseRecord(first.record_path, 80).ticks[0] + 60, "the late client was not late")


def kick_by_one_client_moves_the_cube_on_all_peers(run):
    run.start_server("--cubes=20", "--seconds=5", "--clients=2", "--scripted-motion=off")
    kicker = run.start_client("--autopilot=kick")
    other = run.start_client()
    run.wait(30)
    run.check_logs()
    server, _, _ = server_record(run, 20)
    distance = lever_distance(server.rows[0], server.rows[-1], 0)
    expect(distance > 0.5, f"the kicked cube moved only {distance:.2f} m")
    for client in (kicker, other):
        expect_good_network_errors(run, client, 20)
        shown = PoseRecord(client.record_path, 20)
        # The cube still moves at the end: its displacement is compared between times that both have recorded.
        pairs = [(rows, rows_at(server, server.ticks, tick)[0]) for rows, tick in zip(shown.rows, shown.ticks)]
        pairs = [pair for pair in pairs if pair[1] is not None]
        shown_distance, distance = (lever_distance(pairs[0][side], pairs[-1][side], 0) for side in (0, 1))
        expect(abs(shown_distance - distance) < 0.02,
               f"{client.name} showed the kicked cube moving {shown_distance:.2f} m instead of {distance:.2f} m")


def method_tolerance_and_interpolation_change_during_the_scene(run):
    run.start_server("--cubes=80", "--seconds=9", "--clients=2", "--calm=2")
    changer = run.start_client("--autopilot=settings")
    other = run.start_client()
    run.wait(30)
    run.check_logs()
    expect(changer.report()["method"] == "motors", f"at the end the method is {changer.report()['method']}")
    untimed = sum(tick < 0 for tick in PoseRecord(changer.record_path, 80).ticks)
    expect(untimed > 60, f"the synchronizer was used in only {untimed} frames")
    expect(all(tick >= 0 for tick in PoseRecord(other.record_path, 80).ticks), "the method of the other client changed too")
    for client in (changer, other):
        expect_same_end(run, client, 80)
    # Errors are larger while the tolerance is 20 mm, and each new tolerance restarts the stream.
    expect_errors_within(run, other, 80, share=0.5, maximum=2.0)


def players_have_different_names(run):
    run.start_server("--cubes=20", "--seconds=2", "--clients=4", "--record=")
    for name in ("", "", "Ada", "Ada"):
        run.start_client(f"--name={name}", "--record=")
    run.wait(30)
    run.check_logs()
    joined = sorted(re.findall(r"^(.*) has joined\.$", run.server.log(), re.MULTILINE))
    expect(len(set(joined)) == 4, f"the players are called {joined}")
    expect(joined[:2] == ["Ada", "Ada (2)"] and all(re.fullmatch(r"Player \d", name) for name in joined[2:]),
           f"the players are called {joined}")


def clients_quit_with_a_message_when_the_server_stops(run):
    run.start_server("--cubes=20", "--record=")
    client = run.start_client("--record=")
    run.server.wait_for_line("Player 1 has joined.", START_SECONDS)
    time.sleep(0.5)
    run.server.process.send_signal(signal.SIGKILL)
    run.server.process.wait()
    wait_until(lambda: not client.is_running(), 20, "the client did not quit")
    expect("The connection to the server was lost." in client.log(), f"the client's last line: {client.last_line()}")
    expect(client.process.returncode == 0, f"the client's exit code is {client.process.returncode}")
    client.check_log()


def server_without_clients_quits(run):
    run.start_server("--cubes=20", "--quit-when-empty=on", "--record=")
    client = run.start_client("--record=")
    run.server.wait_for_line("Player 1 has joined.", START_SECONDS)
    client.kill()
    wait_until(lambda: not run.server.is_running(), 20, "the server without clients did not quit")
    expect("Player 1 has left." in run.server.log(), "the server did not report that the player left")
    run.server.check_log()


def invalid_arguments_and_used_ports_are_reported(run):
    run.start_server("--cubes=5", "--record=")
    second = run.start_client("--role=server", "--record=")
    wait_until(lambda: not second.is_running(), START_SECONDS, "the second server on the port did not quit")
    expect(second.process.returncode == 1 and "Cannot listen on UDP port" in second.log(),
           f"second server: {second.process.returncode}, {second.last_line()}")
    expect("SCRIPT ERROR" not in second.log(), "the second server failed with a script error")
    invalid = run.start_client("--cubes=many")
    wait_until(lambda: not invalid.is_running(), START_SECONDS, "the client with an invalid argument did not quit")
    expect(invalid.process.returncode == 2 and re.search(r"--cubes=many is invalid: use a number", invalid.log()) is not None,
           f"invalid argument: {invalid.process.returncode}, {invalid.last_line()}")


def a_port_in_use_is_replaced_and_a_server_of_another_run_is_left(run):
    run.start_server("--cubes=5", "--record=", "--quit-when-empty=on")
    first, used = run.server, run.port
    try:
        run.start_server("--cubes=5", "--record=", "--quit-when-empty=on")
        expect(run.port != used, "the second server of the run did not choose another port")
        joined = run.start_client("--leave-after=0.2", "--record=")
        lost = run.start_client(f"--port={used}", "--session=other", "--record=")
        wait_until(lambda: not joined.is_running() and not lost.is_running(), 30, "the clients did not leave")
    finally:
        first.kill()
    expect(f"Joined the server at 127.0.0.1:{run.port}" in joined.log(), f"the client's last line: {joined.last_line()}")
    message = f"Another server is at 127.0.0.1:{used} (scene cubes, 5 cubes)"
    expect(message in lost.log() and "Joined" not in lost.log(), f"the last line of the client of another run: {lost.last_line()}")


def synchronizer_shows_the_same_scene(run):
    run.start_server("--cubes=40", "--seconds=3", "--clients=1", "--scripted-motion=off", "--method=synchronizer")
    client = run.start_client()
    run.wait(30)
    run.check_logs()
    report = client.report()
    expect(report["bytes"] > 40 * 20 * 2 * 40, f"only {report['bytes']} bytes in 3 s")
    server, _, _ = server_record(run, 40)
    shown = PoseRecord(client.record_path, 40)
    worst = max(lever_distance(server.rows[-1], shown.rows[-1], at) for at in range(0, 40 * ROW_FLOATS, ROW_FLOATS))
    expect(worst < 0.2, f"at the end the error of a cube is {worst * 1000:.0f} mm")


CASES = (
    moving_cubes_match_the_server,
    late_joiner_gets_the_snapshot_and_a_killed_client_affects_no_other,
    kick_by_one_client_moves_the_cube_on_all_peers,
    method_tolerance_and_interpolation_change_during_the_scene,
    players_have_different_names,
    clients_quit_with_a_message_when_the_server_stops,
    server_without_clients_quits,
    invalid_arguments_and_used_ports_are_reported,
    a_port_in_use_is_replaced_and_a_server_of_another_run_is_left,
    synchronizer_shows_the_same_scene,
)
