"""Runs the cases of a suite: functions that raise an AssertionError or a RunFailed if they find a fault."""

import time

from demo_run import RunFailed


def run_cases(suite, cases, call):
    """Runs `call` with each of the cases and prints the results, at the end "[SUITE] N passed, N failed"; returns the exit code."""
    failed = 0
    for case in cases:
        start = time.monotonic()
        try:
            call(case)
            problem = None
        except (AssertionError, RunFailed) as found:
            problem = str(found) or "an assertion without a message failed"
        took = f"{case.__name__} ({time.monotonic() - start:.1f} s)"
        print(f"FAILED {took}: {problem}" if problem else f"ok {took}", flush=True)
        failed += problem is not None
    print(f"[{suite}] {len(cases) - failed} passed, {failed} failed", flush=True)
    return 0 if cases and not failed else 1
