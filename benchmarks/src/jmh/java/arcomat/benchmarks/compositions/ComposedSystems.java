package arcomat.benchmarks.compositions;

import arcomat.benchmarks.compositions.ComposedSystem.Part;
import arcomat.benchmarks.compositions.ComposedSystem.Sight;
import arcomat.benchmarks.compositions.PartKind.Rule;
import arcomat.benchmarks.compositions.PartKind.Way;

import java.util.ArrayList;
import java.util.List;

/** The systems that are asked about. */
final class ComposedSystems {
    private static final int ANY = Rule.ANY;

    private ComposedSystems() {}

    static ComposedSystem of(String name, int size) {
        return switch (name) {
            case "philosophers" -> philosophers(size);
            case "tokens" -> tokens(size);
            case "shift" -> shift(size);
            case "queues" -> queues(size);
            case "leader" -> leader(size);
            default -> throw new IllegalArgumentException(name);
        };
    }

    /**
     * A philosopher asks for the left fork, then for the right one, and eats; a fork answers who
     * has it. Philosopher k is part 2k, its left fork part 2k + 1. No neighbours eat.
     */
    private static ComposedSystem philosophers(int size) {
        PartKind philosopher =
                PartKind.completed(
                        "Philosopher",
                        List.of(3, 3),
                        4,
                        0,
                        4,
                        List.of(
                                rule(0, List.of(ANY, ANY), new Way(0, 0), new Way(1, 1)),
                                rule(1, List.of(0, ANY), new Way(1, 1)),
                                rule(1, List.of(1, ANY), new Way(2, 2)),
                                rule(1, List.of(2, ANY), new Way(1, 1)),
                                rule(2, List.of(ANY, 0), new Way(2, 2)),
                                rule(2, List.of(ANY, 1), new Way(2, 2)),
                                rule(2, List.of(ANY, 2), new Way(3, 3)),
                                rule(3, List.of(ANY, ANY), new Way(3, 3), new Way(0, 0))));
        List<Part> parts = new ArrayList<>();
        List<List<Sight>> forbidden = new ArrayList<>();
        for (int k = 0; k < size; k++) {
            int next = (k + 1) % size;
            int before = (k + size - 1) % size;
            parts.add(new Part(0, List.of(2 * k + 1, 2 * next + 1)));
            parts.add(new Part(1, List.of(2 * k, 2 * before)));
            forbidden.add(List.of(new Sight(2 * k, 3), new Sight(2 * next, 3)));
        }
        return new ComposedSystem(
                "philosophers", size, List.of(philosopher, fork()), parts, 0, forbidden);
    }

    private static PartKind fork() {
        List<Rule> rules = new ArrayList<>();
        for (int left = 0; left < 4; left++) {
            for (int right = 0; right < 4; right++) {
                List<Way> ways = new ArrayList<>();
                if (left == 1) {
                    ways.add(new Way(1, 1));
                }
                if (right == 2) {
                    ways.add(new Way(2, 2));
                }
                if (!ways.isEmpty()) {
                    rules.add(rule(0, List.of(left, right), ways.toArray(Way[]::new)));
                }
            }
        }
        for (int held = 1; held < 4; held++) {
            rules.add(rule(1, List.of(held, ANY), new Way(1, 1)));
            rules.add(rule(2, List.of(ANY, held), new Way(2, 2)));
        }
        rules.add(rule(1, List.of(0, ANY), new Way(0, 0)));
        rules.add(rule(2, List.of(ANY, 0), new Way(0, 0)));
        return PartKind.completed("Fork", List.of(4, 4), 3, 0, 3, rules);
    }

    /** Who has the token passes it on or keeps it, and counts to four for how long it had it. */
    private static ComposedSystem tokens(int size) {
        List<Rule> rules = new ArrayList<>();
        for (int turns = 0; turns < 4; turns++) {
            int next = (turns + 1) % 4;
            rules.add(rule(turns, List.of(1), new Way(4 + turns, 2)));
            rules.add(rule(4 + turns, List.of(ANY), new Way(4 + next, 2), new Way(turns, 1)));
        }
        PartKind station = PartKind.completed("Station", List.of(3), 3, 0, 8, rules);
        PartKind starter = PartKind.completed("Starter", List.of(3), 3, 1, 8, rules);
        List<Part> parts = new ArrayList<>();
        List<List<Sight>> forbidden = new ArrayList<>();
        for (int k = 0; k < size; k++) {
            parts.add(new Part(k == 0 ? 1 : 0, List.of((k + size - 1) % size)));
            for (int other = 0; other < k; other++) {
                forbidden.add(List.of(new Sight(other, 2), new Sight(k, 2)));
            }
        }
        return new ComposedSystem("tokens", size, List.of(station, starter), parts, 0, forbidden);
    }

    /** Sends one of some messages where it reads 1. */
    private static PartKind passingOn(String name, int messages, int sent) {
        return PartKind.completed(
                name,
                List.of(2),
                messages,
                0,
                1,
                List.of(rule(0, List.of(0), new Way(0, 0)), rule(0, List.of(1), new Way(0, sent))));
    }

    /** Each stage sends what it reads. */
    private static ComposedSystem shift(int size) {
        PartKind stage = passingOn("Stage", 3, 1);
        List<Part> parts = new ArrayList<>();
        PartKind later = PartKind.completed("Later", List.of(3), 3, 0, 1, stage.rules());
        for (int k = 0; k < size; k++) {
            parts.add(new Part(k == 0 ? 0 : 1, List.of(k - 1)));
        }
        return new ComposedSystem(
                "shift",
                size,
                List.of(stage, later),
                parts,
                1,
                List.of(List.of(new Sight(size - 1, 2))));
    }

    private static final int CAPACITY = 4;
    private static final int OVERFLOW = 4;

    /**
     * Queues in a row. What is sent is an item, 1, and whether there is room, 2; an item is sent
     * where the next one has room. The first reads whether an item comes, if it had room; the last
     * one reads whether somebody takes it.
     */
    private static ComposedSystem queues(int size) {
        List<Rule> rules = new ArrayList<>();
        for (int held = 0; held <= CAPACITY; held++) {
            for (int before = 0; before < 2; before++) {
                for (int next = 0; next < 2; next++) {
                    int sends = held > 0 && next == 1 ? 1 : 0;
                    int after = held + before - sends;
                    Way way =
                            after > CAPACITY
                                    ? new Way(CAPACITY + 1, OVERFLOW)
                                    : new Way(after, sends + (after <= CAPACITY - 3 ? 2 : 0));
                    rules.add(
                            new Rule(
                                    held,
                                    List.of(
                                            List.of(before, before + 2),
                                            List.of(2 * next, 2 * next + 1)),
                                    List.of(way)));
                }
            }
        }
        rules.add(rule(CAPACITY + 1, List.of(ANY, ANY), new Way(CAPACITY + 1, OVERFLOW)));
        PartKind queue = PartKind.completed("Queue", List.of(5, 5), 5, 0, CAPACITY + 2, rules);
        PartKind source = PartKind.completed("Source", List.of(2, 5), 5, 0, 1, source());
        PartKind sink = passingOn("Sink", 5, 2);
        List<Part> parts = new ArrayList<>();
        List<List<Sight>> forbidden = new ArrayList<>();
        parts.add(new Part(1, List.of(-1, 1)));
        for (int k = 1; k <= size; k++) {
            parts.add(new Part(0, List.of(k - 1, k + 1)));
            forbidden.add(List.of(new Sight(k, OVERFLOW)));
        }
        parts.add(new Part(2, List.of(-2)));
        return new ComposedSystem(
                "queues", size, List.of(queue, source, sink), parts, 2, forbidden);
    }

    private static List<Rule> source() {
        List<Integer> room = List.of(2, 3);
        List<Integer> full = List.of(0, 1, OVERFLOW);
        return List.of(
                rule(0, List.of(0, ANY), new Way(0, 0)),
                new Rule(0, List.of(List.of(1), room), List.of(new Way(0, 1))),
                new Rule(0, List.of(List.of(1), full), List.of(new Way(0, 0))));
    }

    /**
     * Each wakes up when it likes and sends its number round the ring; larger numbers are passed on
     * (Chang, Roberts, "An improved algorithm for decentralized extrema-finding", 1979). Nobody but
     * the largest becomes the leader, who sends a number that is nobody's.
     */
    private static ComposedSystem leader(int size) {
        List<PartKind> kinds = new ArrayList<>();
        List<Part> parts = new ArrayList<>();
        List<List<Sight>> forbidden = new ArrayList<>();
        int elected = size + 1;
        for (int k = 0; k < size; k++) {
            int odd = 2 * k + 1;
            int id = odd <= size ? odd : 2 * (k - (size + 1) / 2) + 2;
            kinds.add(node("Node" + id, id, size));
            parts.add(new Part(k, List.of((k + size - 1) % size)));
            if (id != size) {
                forbidden.add(List.of(new Sight(k, elected)));
            }
        }
        return new ComposedSystem("leader", size, kinds, parts, 0, forbidden);
    }

    /** State 0 sleeps, 1 is awake, 2 passes on, 3 leads. */
    private static PartKind node(String name, int id, int size) {
        int elected = size + 1;
        List<Rule> rules = new ArrayList<>();
        rules.add(rule(0, List.of(0), new Way(0, 0), new Way(1, id)));
        for (int read = 1; read <= size; read++) {
            rules.add(
                    read > id
                            ? rule(0, List.of(read), new Way(2, read))
                            : rule(0, List.of(read), new Way(1, id)));
            if (read >= id) {
                Way way = read == id ? new Way(3, elected) : new Way(1, read);
                rules.add(rule(1, List.of(read), way));
            }
            rules.add(rule(2, List.of(read), new Way(2, read)));
        }
        return PartKind.completed(name, List.of(size + 2), size + 2, 0, 4, rules);
    }

    private static Rule rule(int state, List<Integer> read, Way... ways) {
        return Rule.of(state, read, ways);
    }
}
