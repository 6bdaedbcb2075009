"""The options of the demo that impair the network between clients and the server, in each direction."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Condition:
    """One impairment; `words` describes it, with {} for the value."""

    name: str
    metavar: str
    most: int
    help: str
    words: str


CONDITIONS = (
    Condition("loss", "PERCENT", 90, "packet loss", "{} % loss"),
    Condition("burst", "PACKETS", 100, "mean length of a burst of lost packets", "in bursts of {} packets"),
    Condition("delay", "MS", 2000, "one-way delay", "{} ms delay"),
    Condition("jitter", "MS", 2000, "random additional delay, from 0 to this; packets can be reordered", "up to {} ms jitter"),
    Condition("reorder", "PERCENT", 100, "packets that are additionally reordered", "{} % reordered"),
    Condition("duplicate", "PERCENT", 100, "duplicated packets", "{} % duplicated"),
    Condition("rate", "BYTES", 10 ** 9, "bandwidth in bytes per second; packets beyond it wait in a short queue", "at most {} bytes/s"),
)


def add_arguments(parser, number_within):
    """Adds the options, in a group of their own; `number_within(least, most)` makes their types."""
    group = parser.add_argument_group("network", "impairments in each direction, by a proxy in front of each client; seeded")
    for condition in CONDITIONS:
        group.add_argument("--" + condition.name, type=number_within(0, condition.most), default=0,
                           metavar=condition.metavar, help=condition.help)


def client_arguments(options, seed):
    """The arguments of a client of the demo."""
    chosen = [f"--{condition.name}={getattr(options, condition.name)}" for condition in CONDITIONS
              if getattr(options, condition.name)]
    return [*chosen, f"--seed={seed}"] if chosen else []


def describe(options):
    """A description of the impairments; empty if there are none."""
    chosen = [condition.words.format(getattr(options, condition.name)) for condition in CONDITIONS
              if getattr(options, condition.name)]
    return ", ".join(chosen)


def longest_delay(options):
    """The maximum delay of a packet in the network, in seconds."""
    return (options.delay + options.jitter) / 1000.0
