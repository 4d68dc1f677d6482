package statemachine;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.Collectors;

/**
 * A machine that was drawn by lot, over two inputs (a, b), two variables (n, m) and three outputs:
 * transitions send on x, entries on y and exits on z; what is done meanwhile sends on w.
 *
 * @param priority {@code inner}, {@code outer}, or nothing
 */
record DrawnMachine(String priority, Node root, List<Move> moves) {
    /** A value: a number, or the sum of a number and n, modulo 8. */
    record Value(boolean n, int number) {
        String text() {
            return n ? "(n + %d) %% 8".formatted(number) : String.valueOf(number);
        }
    }

    record Write(String name, Value value) {}

    /**
     * @param parts the first of which is where it begins
     */
    record Node(
            String name,
            List<Node> parts,
            List<Write> entry,
            List<Write> exit,
            List<Write> during) {
        boolean isSimple() {
            return parts.isEmpty();
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
        Drawing drawing = new Drawing(random);
        Node root = drawing.node("", 0);
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
        Move fresh = new Drawing(random).move(states);
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
        private int states;

        Drawing(Random random) {
            this.random = random;
        }

        Node node(String name, int depth) {
            int parts = depth == 0 || depth < 3 && random.nextInt(5) < 2 ? 2 : 0;
            parts += parts > 0 ? random.nextInt(2) : 0;
            List<Node> nodes = new ArrayList<>();
            for (int i = 0; i < parts; i++) {
                nodes.add(node("s" + states++, depth + 1));
            }
            List<Write> entry = new ArrayList<>();
            List<Write> exit = new ArrayList<>();
            List<Write> during = new ArrayList<>();
            if (depth > 0) {
                maybe(entry, "n");
                maybe(entry, "m");
                maybe(exit, "m");
                maybe(during, "m");
                if (parts == 0) {
                    maybe(entry, "y");
                    maybe(exit, "z");
                    maybe(during, "w");
                }
            }
            return new Node(name, nodes, entry, exit, during);
        }

        private void maybe(List<Write> writes, String name) {
            if (random.nextInt(3) == 0) {
                writes.add(new Write(name, new Value(false, random.nextInt(8))));
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
                writes.add(new Write("x", new Value(random.nextBoolean(), random.nextInt(8))));
            }
            if (random.nextInt(3) == 0) {
                writes.add(new Write("n", new Value(true, random.nextInt(8))));
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

    /** As a component. */
    String text(String name) {
        StringBuilder text = new StringBuilder();
        text.append("component ").append(name).append(" {\n");
        text.append(
                "port in Boolean a, out Integer x, out Integer y, out Integer z, out Integer w;\n");
        text.append("<<completion = \"ignore\">> statemachine {\n");
        text.append("variable Integer[0..7] n = 0, m = 0;\n");
        text.append(priority.isEmpty() ? "" : "priority " + priority + ";\n");
        write(root, text);
        moves.forEach(move -> write(move, text));
        return text.append("}\n}\n").toString();
    }

    private static void write(Node node, StringBuilder text) {
        action("entry", node.entry(), text);
        action("exit", node.exit(), text);
        action("do", node.during(), text);
        if (!node.isSimple()) {
            text.append("initial ").append(node.parts().get(0).name()).append(";\n");
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
