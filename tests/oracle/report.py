"""Counts what was compared, and says so."""

import numpy as np


class Report:
    """One line for each check: cases, worst error, bound."""

    def __init__(self):
        self.passed = 0
        self.failed = 0

    def check(self, name, errors, bound):
        """Errors of all cases of a check, which passes if it has cases and each error is at most the bound."""
        errors = np.asarray(errors, float).ravel()
        worst = np.max(errors) if len(errors) and not np.isnan(errors).any() else np.nan
        good = bool(worst <= bound)
        if good:
            self.passed += 1
        else:
            self.failed += 1
        verdict = "ok" if good else "FAILED"
        print(f"{name:<58} {len(errors):>7,} cases  worst {worst:8.2g}  bound {bound:.0e}  {verdict}", flush=True)

    def end(self):
        """The line that tools/test reads; the exit code."""
        print(f"[algebra] {self.passed} passed, {self.failed} failed", flush=True)
        return 1 if self.failed or not self.passed else 0
