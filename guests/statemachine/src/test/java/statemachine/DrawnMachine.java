package statemachine;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * A machine that was drawn by lot, over an input (a), two variables (n, m) and outputs: transitions
 * send on x, and what is done meanwhile on w. Entries send on y, exits on z and beginnings on v,
 * each with the depth of its state behind it, so that no step sends twice on a port; or, in a
 * machine that is careless, all of them on y.
 *
 * @param priority {@code inner}, {@code outer}, or nothing
 */
record DrawnMachine(String priority, Node root, List<Move> moves) {
    static final List<String> PORTS =
            List.of("x", "w", "y1", "y2", "y3", "z1", "z2", "z3", "v0", "v1", "v2", "y");

    /**
     * A value: a number, the sum of a number and n, modulo 8, or one that needs a message on a.
     *
     * @param number of one that reads a, what it is for {@code false}
     */
    record Value(Reads reads, int number) {
        String text() {
            return switch (reads) {
                case NOTHING -> String.valueOf(number);
                case N -> "(n + %d) %% 8".formatted(number);
                case A -> "(a == true ? 1 : %d)".formatted(number);
            };
        }
    }

    /** What a value is made of. */
    enum Reads {
        NOTHING,
        N,
        A
    }

    record Write(String name, Value value) {}

    /**
     * @param first the name of the part where it begins, if it has parts
     * @param beginning what is done then
     */
    record Node(
            String name,
            List<Node> parts,
            String first,
            List<Write> beginning,
            List<Write> entry,
            List<Write> exit,
            List<Write> during) {
        boolean isSimple() {
            return parts.isEmpty();
        }

        /** There is no input then. */
        boolean readsAtTheStart() {
            return Stream.concat(entry.stream(), beginning.stream())
                            .anyMatch(write -> write.value().reads() == Reads.A)
                    || parts.stream()
                            .anyMatch(part -> part.name().equals(first) && part.readsAtTheStart());
        }

        /** It and all that stands in it. */
        List<Node> all() {
            List<Node> all = new ArrayList<>(List.of(this));
            parts.forEach(part -> all.addAll(part.all()));
            return all;
        }
    }

    /**
     * @param below n has to be smaller
     * @param input what is asked of a: {@code true}, {@code false}, {@code --} or {@code ?}
     * @param memory behind the target: nothing, {@code .history} or {@code .deepHistory}
     */
    record Move(
            String source,
            Optional<String> target,
            String memory,
            Optional<Integer> below,
            Optional<String> input,
            List<Write> writes) {}

    static DrawnMachine draw(Random random) {
        return draw(random, false);
    }

    /**
     * @param careless whether steps may send twice on a port
     */
    static DrawnMachine draw(Random random, boolean careless) {
        Drawing drawing = new Drawing(random, careless);
        Node root = drawing.node("", 0);
        while (root.readsAtTheStart()) {
            root = drawing.node("", 0);
        }
        List<Node> states = root.all().subList(1, root.all().size());
        List<Move> moves = new ArrayList<>();
        for (int i = 0; i < 3 + random.nextInt(8); i++) {
            moves.add(drawing.move(states));
        }
        String priority = List.of("", "inner", "outer").get(random.nextInt(3));
        return new DrawnMachine(priority, root, moves);
    }

    /** Nearly the same: another one comes first, or one move goes elsewhere. */
    DrawnMachine variant(Random random) {
        if (random.nextInt(3) == 0) {
            String other = List.of("", "inner", "outer").get(random.nextInt(3));
            return new DrawnMachine(other, root, moves);
        }
        List<Node> states = root.all().subList(1, root.all().size());
        List<Move> others = new ArrayList<>(moves);
        int place = random.nextInt(moves.size());
        Move old = moves.get(place);
        Move fresh = new Drawing(random, false).move(states);
        others.set(
                place,
                new Move(
                        old.source(),
                        fresh.target(),
                        fresh.memory(),
                        old.below(),
                        old.input(),
                        old.writes()));
        return new DrawnMachine(priority, root, others);
    }

    private static final class Drawing {
        private final Random random;
        private final boolean careless;
        private int states;

        Drawing(Random random, boolean careless) {
            this.random = random;
            this.careless = careless;
        }

        Node node(String name, int depth) {
            int parts = depth == 0 || depth < 3 && random.nextInt(5) < 2 ? 2 : 0;
            parts += parts > 0 ? random.nextInt(2) : 0;
            List<Node> nodes = new ArrayList<>();
            for (int i = 0; i < parts; i++) {
                nodes.add(node("s" + states++, depth + 1));
            }
            List<Write> beginning = new ArrayList<>();
            if (parts > 0) {
                maybe(beginning, "n");
                maybe(beginning, "m");
                maybe(beginning, port("v", depth));
            }
            List<Write> entry = new ArrayList<>();
            List<Write> exit = new ArrayList<>();
            List<Write> during = new ArrayList<>();
            if (depth > 0) {
                maybe(entry, "n");
                maybe(entry, "m");
                maybe(entry, port("y", depth));
                maybe(exit, "m");
                maybe(exit, port("z", depth));
                maybe(during, "m");
                if (parts == 0) {
                    maybe(during, "w");
                }
            }
            String first = parts == 0 ? "" : nodes.get(random.nextInt(parts)).name();
            return new Node(name, nodes, first, beginning, entry, exit, during);
        }

        private String port(String kind, int depth) {
            return careless ? "y" : kind + depth;
        }

        private void maybe(List<Write> writes, String name) {
            if (random.nextInt(3) == 0) {
                Reads reads = random.nextInt(8) == 0 ? Reads.A : Reads.NOTHING;
                writes.add(new Write(name, new Value(reads, random.nextInt(8))));
            }
        }

        Move move(List<Node> nodes) {
            Node source = nodes.get(random.nextInt(nodes.size()));
            Node target = nodes.get(random.nextInt(nodes.size()));
            boolean inner = random.nextInt(5) == 0;
            String memory =
                    inner || target.isSimple()
                            ? ""
                            : List.of("", ".history", ".deepHistory").get(random.nextInt(3));
            List<Write> writes = new ArrayList<>();
            if (random.nextInt(5) > 0) {
                Reads reads = Reads.values()[random.nextInt(3)];
                writes.add(new Write("x", new Value(reads, random.nextInt(8))));
            }
            if (random.nextInt(3) == 0) {
                writes.add(new Write("n", new Value(Reads.N, random.nextInt(8))));
            }
            return new Move(
                    source.name(),
                    inner ? Optional.empty() : Optional.of(target.name()),
                    memory,
                    random.nextInt(4) == 0 ? Optional.of(random.nextInt(8)) : Optional.empty(),
                    random.nextInt(4) == 0
                            ? Optional.empty()
                            : Optional.of(
                                    List.of("true", "false", "--", "?").get(random.nextInt(4))),
                    writes);
        }
    }

    /**
     * As a component.
     *
     * @param name with what may follow it
     */
    String text(String name) {
        StringBuilder text = new StringBuilder();
        text.append("component ").append(name).append(" {\n");
        text.append(ports());
        text.append("<<completion = \"ignore\">> statemachine {\n");
        text.append("variable Integer[0..7] n = 0, m = 0;\n");
        text.append(priority.isEmpty() ? "" : "priority " + priority + ";\n");
        write(root, text);
        moves.forEach(move -> write(move, text));
        return text.append("}\n}\n").toString();
    }

    /** Of each machine. */
    static String ports() {
        return PORTS.stream()
                .map(port -> ", out Integer " + port)
                .collect(Collectors.joining("", "port in Boolean a", ";\n"));
    }

    private static void write(Node node, StringBuilder text) {
        action("entry", node.entry(), text);
        action("exit", node.exit(), text);
        action("do", node.during(), text);
        if (!node.isSimple()) {
            text.append("initial ").append(node.first());
            text.append(block(node.beginning())).append(";\n");
        }
        for (Node part : node.parts()) {
            text.append("state ").append(part.name()).append(" {\n");
            write(part, text);
            text.append("}\n");
        }
    }

    private static void action(String word, List<Write> writes, StringBuilder text) {
        if (!writes.isEmpty()) {
            text.append(word).append(block(writes)).append(";\n");
        }
    }

    private static void write(Move move, StringBuilder text) {
        text.append(move.source());
        move.target().ifPresent(each -> text.append(" -> ").append(each).append(move.memory()));
        move.below().ifPresent(number -> text.append(" [n < ").append(number).append("]"));
        move.input().ifPresent(asked -> text.append(" {a == ").append(asked).append("}"));
        text.append(block(move.writes())).append(";\n");
    }

    private static String block(List<Write> writes) {
        return writes.isEmpty()
                ? ""
                : writes.stream()
                        .map(write -> write.name() + " = " + write.value().text())
                        .collect(Collectors.joining(", ", " / {", "}"));
    }
}
