"""Tables of the suite network: one line per method, and a comparison of cost at equal error."""

OURS = "ga_godot"
# At this maximum latency in ms and above, any rate that has the accuracy also has the delay.
REFERENCE_LATENCY = 200
# Case of the rows, heading, format.
COLUMNS = (("bytes_per_second_per_body", "B/s/body", "{:.1f}"), ("packets_per_second", "packets/s", "{:.1f}"),
           ("error_p50", "p50 mm", "{:.2f}"), ("error_p99", "p99 mm", "{:.2f}"), ("error_max", "max mm", "{:.1f}"),
           ("error_rest_p99", "at rest p99", "{:.2f}"), ("playback_delay", "delay ms", "{:.0f}"))


def by_subject(rows):
    """{subject: {case: value}}, in the order of the rows."""
    methods = {}
    for row in rows:
        methods.setdefault(row["subject"], {})[row["case"]] = row["value"]
    return methods


def print_trace(name, rows, link):
    """Prints cost and error of each method on a trace, then the comparison at equal error."""
    methods = by_subject(rows)
    ours = methods[OURS]
    bodies, runs = rows[0]["n"], rows[0]["runs"]
    print(f"\n{name}: {bodies} {'body' if bodies == 1 else 'bodies'}, {ours['samples_moving'] / runs:.0f} samples in motion; {link}"
          + (f"; {runs} runs\n" if runs > 1 else "\n"))
    print(f"{'':<26}" + "".join(f"{heading:>13}" for _, heading, _ in COLUMNS))
    for subject, values in methods.items():
        print(f"{subject:<26}" + "".join(f"{number(values[case], form):>13}" for case, _, form in COLUMNS))
    print(f"\n{OURS}: median playback delay {number(ours['playback_delay_median'], '{:.0f}')} ms; acknowledgements "
          f"{ours['ack_bytes_per_second_per_body']:.2f} B/s/body; encode {number(ours['encode'], '{:.0f}')} ns/pose, "
          f"decode {number(ours['decode'], '{:.0f}')} ns/pose; {number(ours['allocations_per_packet'], '{:.1f}')} allocations/packet")
    if ours["samples_unseen"]:
        print(f"{OURS}: {ours['samples_unseen']:.0f} samples were not shown: their times passed before the receiver could show the body")
    print(comparison(methods, "paper_motor_float32_", "the paper's scheme"))
    print(comparison(methods, "pqs_float32_", "the cheapest baseline"), flush=True)
    if ours_settings(rows)["latency_ms"] < REFERENCE_LATENCY:
        print(comparison(no_slower(methods), "pqs_float32_", "the cheapest baseline with no more delay"), flush=True)


def ours_settings(rows):
    """A row of ours, which has our settings."""
    return next(row for row in rows if row["subject"] == OURS)


def no_slower(methods):
    """The methods whose median playback delay is not longer than ours."""
    limit = methods[OURS]["playback_delay_median"]
    return {subject: values for subject, values in methods.items() if values["playback_delay_median"] <= limit}


def comparison(methods, prefix, name):
    """Compares our cost with that of the cheapest baseline with this prefix whose p99 is no worse."""
    ours = methods[OURS]
    if ours["error_p99"] is None:
        return f"{OURS} showed no moving body"
    baselines = {subject: values for subject, values in methods.items()
              if subject.startswith(prefix) and values["error_p99"] is not None}
    if not baselines:
        return f"{OURS}: {name} showed no moving body"
    equals = [subject for subject, values in baselines.items() if values["error_p99"] <= ours["error_p99"]]
    if equals:
        best = min(equals, key=lambda subject: baselines[subject]["bytes_per_second_per_body"])
        meaning = f"{name} whose p99 error is not larger ({best})"
    else:
        best = min(baselines, key=lambda subject: baselines[subject]["error_p99"])
        meaning = f"{best}, whose p99 is the best of {prefix}* but worse than that of {OURS}"
    return f"{OURS}: 1/{baselines[best]['bytes_per_second_per_body'] / ours['bytes_per_second_per_body']:.1f} of {meaning}"


def print_server(rows, link):
    """Prints the load of a server."""
    values = by_subject(rows)[OURS]
    print(f"\nserver: 1,000 moving bodies, 64 receivers, observed at 60 Hz, sent at 20 Hz; {link}\n"
          f"{OURS}: {100 * values['server_core_share']:.1f} % of a core; {values['server_bytes_per_second_per_body']:.1f} B/s/body "
          f"and {values['server_packets_per_second'] / 64:.0f} packets/s to each receiver", flush=True)


def number(value, form):
    """A formatted value; a dash for None."""
    return "-" if value is None else form.format(value)
