"""The options of the demo that make the network between a client and the server bad, in each direction."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Condition:
    """One way of being bad; `words` says it in a sentence, with the value in place of {}."""

    name: str
    metavar: str
    most: int
    help: str
    words: str


CONDITIONS = (
    Condition("loss", "PERCENT", 90, "share of the packets that are lost", "{} % loss"),
    Condition("burst", "PACKETS", 100, "mean number of packets that are lost in a row", "in rows of {} packets"),
    Condition("delay", "MS", 2000, "time that every packet takes", "{} ms delay"),
    Condition("jitter", "MS", 2000, "random time on top, from 0 to this; packets overtake each other", "up to {} ms jitter"),
    Condition("reorder", "PERCENT", 100, "share of the packets that others overtake besides", "{} % reordered"),
    Condition("duplicate", "PERCENT", 100, "share of the packets that come twice", "{} % duplicated"),
    Condition("rate", "BYTES", 10 ** 9, "bytes a second that pass; what does not fit waits in a short queue", "at most {} bytes/s"),
)


def add_arguments(parser, number_within):
    """Adds the options, in a group of their own; `number_within(least, most)` makes their types."""
    group = parser.add_argument_group("network", "made bad in each direction, by a proxy in front of each client; seeded")
    for condition in CONDITIONS:
        group.add_argument("--" + condition.name, type=number_within(0, condition.most), default=0,
                           metavar=condition.metavar, help=condition.help)


def client_arguments(options, seed):
    """What a client of the demo is started with."""
    chosen = [f"--{condition.name}={getattr(options, condition.name)}" for condition in CONDITIONS
              if getattr(options, condition.name)]
    return [*chosen, f"--seed={seed}"] if chosen else []


def describe(options):
    """The network in words; empty if nothing is bad."""
    chosen = [condition.words.format(getattr(options, condition.name)) for condition in CONDITIONS
              if getattr(options, condition.name)]
    return ", ".join(chosen)


def longest_delay(options):
    """Seconds by which the network delays a packet at most."""
    return (options.delay + options.jitter) / 1000.0
