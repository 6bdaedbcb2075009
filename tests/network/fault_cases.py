"""Faults of processes, of the network, of clocks and of versions."""

import os

from fault_session import ClockSession, CutSession, RestartSession, StopSession
from situation_checks import Findings, median_delay, truth_of, warnings_of
from situation_session import Session, run_together

FAULT_AT, LONG_FAULT_AT = 2.5, 22.0
SETTLING = 1.5
# Seconds after a fault from which motion is smooth and the delay is at most that of a bad network.
SMOOTH_AFTER = 1.5
# Seconds after a fault from which the delay is as before. Receivers adapt to the lateness of a short cut for 7 s, like to jitter.
NORMAL_AFTER, NORMAL_AFTER_SHORT_CUT = 2.0, 12.0
WATCHED = 1.5
SHORT_CUT = 1.5
MAX_DELAY = 0.3
DELAY_SLACK = 0.05
# ENet's limit of silence, in ms: above all faults of a process or the network, and short for a server that restarts.
PATIENT, IMPATIENT = 90_000, 1_000


def is_long():
    return "GA_GODOT_SESSION_SECONDS" in os.environ  # --long of run.py


def motion_continues_after_cuts_and_stopped_processes(run):
    """The network is cut for 1 and 5 s, with --long also 30 s; server or client are stopped (SIGSTOP) for 3 s, with --long 10 s."""
    # Before a long cut, the peers have stopped to send reliable packets, for which ENet would wait long after it.
    at = LONG_FAULT_AT if is_long() else FAULT_AT

    def options(seconds, after):
        return {"seconds": at + seconds + after + WATCHED + 1.0, "timeout": PATIENT}

    stop = 10.0 if is_long() else 3.0
    faults = []
    for seconds in (1.0, 5.0, 30.0) if is_long() else (1.0, 5.0):
        after = NORMAL_AFTER if seconds > SHORT_CUT else NORMAL_AFTER_SHORT_CUT
        faults.append((CutSession(f"network cut for {seconds:g} s", at, seconds, **options(seconds, after)), seconds, after))
    for is_server in (True, False):
        name = f"{'server' if is_server else 'client'} stopped for {stop:g} s"
        faults.append((StopSession(name, at, stop, is_server, **options(stop, NORMAL_AFTER)), stop, NORMAL_AFTER))
    run_together(run, [session for session, _, _ in faults])
    findings = Findings([session for session, _, _ in faults])
    for session, seconds, after in faults:
        truth, shown = truth_of(session, "A"), session.clients[0].record
        before = shown.shown("A", shown.begin + SETTLING, shown.begin + at - 0.2)
        normal = median_delay(before, truth)
        end = shown.begin + at + seconds
        samples = shown.shown("A", end + SMOOTH_AFTER, end + after + WATCHED)
        findings.smooth(session.name, samples)
        findings.delay(f"{session.name}, at once", samples, truth, 0.0, MAX_DELAY + DELAY_SLACK)
        findings.delay(f"{session.name}, after {after:g} s", shown.shown("A", end + after, end + after + WATCHED), truth,
                       0.0, normal + DELAY_SLACK, DELAY_SLACK)
        expect_quiet(findings, session)
    findings.raise_failures()


def clients_continue_with_a_restarted_server(run):
    """A client and the server are killed; the server starts again on its port, and the other clients connect again."""
    session = RestartSession("server restarted", FAULT_AT, FAULT_AT + 0.5, clients=3, seconds=5.0, timeout=IMPATIENT)
    run_together(run, [session])
    findings = Findings([session])
    truth = truth_of(session, "A")
    for client in session.clients:
        shown = client.record
        findings.check("lost" in shown.events, f"{client.name} did not lose the server")
        begin = shown.events.get("begin 2")
        findings.check(begin is not None, f"{client.name} did not reach the restarted server")
        if begin is not None:
            samples = shown.shown("A", begin + SMOOTH_AFTER, truth.samples[-1].wall)
            findings.smooth(f"{client.name} after the restart", samples)
            findings.delay(f"{client.name} after the restart", samples, truth, 0.0, 0.3, DELAY_SLACK)
    expect_quiet(findings, session)
    findings.raise_failures()


def steps_of_the_wall_clock_change_nothing(run):
    """The wall clock of the server or of the client jumps by hours, forward and back."""
    plans = {"server": [(2.0, "server", 1), (2.8, "server", -1)], "client": [(2.0, "client1", 1), (2.8, "client1", -1)]}
    sessions = [ClockSession(f"clock of the {name} steps", steps, seconds=4.5) for name, steps in plans.items()]
    run_together(run, sessions)
    findings = Findings(sessions)
    for session in sessions:
        truth, shown = truth_of(session, "A"), session.clients[0].record
        samples = shown.shown("A", shown.begin + SETTLING, truth.samples[-1].wall)
        findings.smooth(session.name, samples)
        findings.delay(session.name, samples, truth, 0.0, 0.3, DELAY_SLACK)
        expect_quiet(findings, session)
    findings.raise_failures()


def peers_of_other_versions_are_refused_with_one_message(run):
    """A client of an older or newer version, among others; each side names both versions, once."""
    # (layer, version of client 1, versions that it and the server name)
    rows = [("session", 0, 3), ("session", 2, 3), ("stream", 0, 150), ("stream", 200, 150)]
    sessions = [Session(f"{layer} version {version}", "versions", clients=2, seconds=5.0, layer=layer, version=version)
                for layer, version, _ in rows]
    run_together(run, sessions[:2])
    run_together(run, sessions[2:])
    findings = Findings(sessions)
    for session, (layer, version, seen) in zip(sessions, rows):
        other, client = session.clients
        for process, named in ((session.server, version), (other, seen)):
            found = [text for text in warnings_of(process) if f"version {named} of the {layer} format, but this peer uses" in text]
            print(f"   {session.name}: {process.name} warns: {found}", flush=True)
            findings.check(len(found) == 1, f"{session.name}: {process.name} has {len(found)} such messages instead of 1")
            findings.check(all("install the same version of the GA-Godot addon on all peers" in text for text in found),
                           f"{session.name}: {process.name} does not say what to do: {found}")
        truth, shown = truth_of(session, "A"), client.record
        findings.smooth(session.name, shown.shown("A", shown.begin + SETTLING, truth.samples[-1].wall))
        at_rest = {sample.position for sample in other.record.shown("A")}
        findings.check(len(at_rest) <= 1, f"{session.name}: the client of another version shows motion")
        findings.check(not warnings_of(client), f"{session.name}: the other client warns: {warnings_of(client)[:1]}")
    findings.raise_failures()


def expect_quiet(findings, session):
    for process in session.processes():
        findings.check(not warnings_of(process), f"{session.name}: {process.name} warns: {warnings_of(process)[:2]}")


CASES = (
    motion_continues_after_cuts_and_stopped_processes,
    clients_continue_with_a_restarted_server,
    steps_of_the_wall_clock_change_nothing,
    peers_of_other_versions_are_refused_with_one_message,
)
