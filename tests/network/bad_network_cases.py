"""Sessions over an impaired network: the demo's proxy between each client and the server, in both directions."""

import os
import signal
import time

from checks import expect, expect_errors_within, expect_same_end, resident_bytes
from demo_run import START_SECONDS

# Duration of the session in which players join and leave; --long of run.py sets 60.
SECONDS = 20
CALM = 4
# Seconds in which a client's playback delay adapts to the jitter.
SETTLING = 3
BAD = ("--loss=30", "--jitter=100", "--reorder=10", "--duplicate=10")
# Maximum growth of resident memory, in bytes, after the first third of a session.
MAX_GROWTH = 8_000_000
# A client process that stops for this many seconds loses most of the packets meanwhile.
STOPPED = 1.5


def packets_dropped_by_a_busy_machine_count_as_lost(run):
    """The engine's method; the client's process, and with it the proxy, stops for a while."""
    run.start_server("--cubes=250", "--seconds=5", "--clients=1", "--method=synchronizer", "--record=")
    client = run.start_client("--delay=1", "--record=")
    run.server.wait_for_line("The scene begins", START_SECONDS)
    time.sleep(1)
    client.process.send_signal(signal.SIGSTOP)
    time.sleep(STOPPED)
    client.process.send_signal(signal.SIGCONT)
    run.wait(30)
    run.check_logs()
    expect("Buffer full" not in client.log(), "the engine dropped packets in the proxy")
    report, sent = client.report(), run.server.report()["total_packets"]
    counted = report["total_packets"]
    print(f"   {report['lost']} of {counted} packets lost; the server has sent {sent:.0f}", flush=True)
    expect(report["lost"] > 50, f"only {report['lost']} packets counted as lost in {STOPPED} s without reading")
    # The two counts end a network delay apart.
    expect(abs(counted - sent) < 0.03 * sent, f"the client counts {counted} packets, the server has sent {sent:.0f}")


def recovers_from_loss_and_jitter(run):
    run.start_server("--cubes=80", "--seconds=9", "--clients=1", "--calm=2")
    client = run.start_client("--loss=15", "--jitter=40", "--seed=7")
    run.wait(30)
    run.check_logs()
    expect_same_end(run, client, 80)
    expect_errors_within(run, client, 80, maximum=1.0, after=SETTLING)


def recovers_from_bursts_delay_and_limited_bandwidth(run):
    run.start_server("--cubes=80", "--seconds=7", "--clients=1", "--calm=2")
    client = run.start_client("--loss=10", "--burst=4", "--delay=80", "--rate=60000", "--seed=3")
    run.wait(30)
    run.check_logs()
    expect_same_end(run, client, 80)


def all_peers_converge_while_others_join_and_leave(run):
    """Players join, leave and are killed; 30 % loss, up to 100 ms of jitter, reordering and duplication."""
    seconds = int(os.environ.get("GA_GODOT_SESSION_SECONDS", SECONDS))
    run.start_server("--cubes=120", f"--seconds={seconds}", f"--calm={CALM}", "--clients=2")
    stay = [run.start_client(*BAD, "--seed=1"), run.start_client(*BAD, "--seed=2", "--autopilot=circle")]
    run.server.wait_for_line("The scene begins", START_SECONDS)
    begin = time.monotonic()
    memory = {}
    guests = 0
    while time.monotonic() - begin < seconds - CALM - 4:
        guests += 1
        guest = run.start_client(*BAD, f"--seed={2 + guests}", "--record=", "--leave-after=2", "--autopilot=kick")
        time.sleep(3)
        # Every second guest is killed and cannot close its stream.
        if guests % 2:
            guest.kill()
        else:
            guest.process.wait(timeout=START_SECONDS)
        guest.check_log()
        run.clients.remove(guest)
        if not memory and time.monotonic() - begin > seconds / 3:
            memory = {process.name: resident_bytes(process.process) for process in [run.server, *stay]}
    late = run.start_client(*BAD, "--seed=99")
    run.server.wait_for_line(f"Player {len(run.clients)} has joined", START_SECONDS)
    for process in [run.server, *stay]:
        now = resident_bytes(process.process)
        before = memory.get(process.name)
        if now is not None and before is not None:
            expect(now - before < MAX_GROWTH, f"{process.name} grew by {(now - before) / 1e6:.1f} MB")
    run.wait(seconds + 30)
    run.check_logs()
    expect(guests >= 3, f"only {guests} guests joined; at least 3 are needed")
    for client in [*stay, late]:
        expect_same_end(run, client, 120)
    for client in stay:
        expect_errors_within(run, client, 120, share=0.75, maximum=float("inf"), after=SETTLING)


CASES = (
    packets_dropped_by_a_busy_machine_count_as_lost,
    recovers_from_loss_and_jitter,
    recovers_from_bursts_delay_and_limited_bandwidth,
    all_peers_converge_while_others_join_and_leave,
)
