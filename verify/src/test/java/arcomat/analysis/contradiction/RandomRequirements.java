package arcomat.analysis.contradiction;

import arcomat.models.ReadModels;
import arcomat.semantics.Promise;
import arcomat.source.SourceFile;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/**
 * Arbitrary requirements as text, small enough for every letter to be written out: ranges that may
 * be left, divisions, all completions, ports that none of the automata writes, delays in mixture,
 * several beginnings, outputs that are free where they are left out, total ports, and events with
 * latched ports. The same seed gives the same text.
 */
final class RandomRequirements {
    /** An output port; what most automata send on it at the beginning. */
    private record Out(
            String name, String type, int values, boolean total, int delay, String first) {}

    private final Random random;
    private final boolean events;
    private final boolean flag;
    private final boolean totalIn;
    private final boolean held;
    private final int keys;

    /** Of six transitions so many have an alternative, and so many more are left out. */
    private final int alternatives;

    private final int gaps;
    private final List<Out> outputs = new ArrayList<>();

    private RandomRequirements(long seed) {
        random = new Random(seed);
        events = random.nextInt(6) == 0;
        keys = 1 + random.nextInt(2);
        alternatives = 1 + random.nextInt(5);
        gaps = random.nextInt(7 - alternatives);
        flag = random.nextInt(3) == 0;
        totalIn = !events && random.nextInt(3) == 0;
        held = events && random.nextInt(2) == 0;
        int component = random.nextInt(2);
        for (int i = 0; i < 1 + random.nextInt(2); i++) {
            int values = 1 + random.nextInt(3);
            boolean total = !events && random.nextInt(6) == 0;
            int delay = random.nextInt(3) == 0 ? 1 - component : component;
            String name = String.valueOf((char) ('y' + i));
            String first = value(total, values);
            String type = "Integer[0..%d]".formatted(values - 1);
            outputs.add(new Out(name, type, values, total, events ? 1 : delay, first));
        }
    }

    private String value(boolean total, int values) {
        return !total && random.nextInt(3) == 0 ? "--" : String.valueOf(random.nextInt(values));
    }

    static SourceFile text(long seed) {
        return new SourceFile("law/R.arc", new RandomRequirements(seed).text());
    }

    static Promise of(SourceFile file) {
        return Promise.of(ReadModels.model(file).component("law.R").orElseThrow(), List.of());
    }

    private String text() {
        StringBuilder text = new StringBuilder("package law;\n\ncomponent R {\n");
        text.append(events ? "  timing untimed;\n" : "").append("  port ");
        text.append(totalIn ? "<<total>> " : "").append("in Integer[0..%d] a".formatted(keys - 1));
        text.append(flag ? ", in Boolean b" : "");
        text.append(held ? ", <<state>> in Boolean h" : "");
        for (Out out : outputs) {
            String delay = "<<delay = \"%d\"%s>> ".formatted(out.delay, out.total ? ", total" : "");
            text.append(", ").append(events ? "" : delay);
            text.append("out %s %s".formatted(out.type, out.name));
        }
        text.append(random.nextInt(3) == 0 ? ", out Boolean w;\n" : ";\n");
        int count = 1 + random.nextInt(4);
        for (int i = 0; i < count; i++) {
            text.append(automaton("r" + i, count == 1));
        }
        return text.append("}\n").toString();
    }

    private String automaton(String name, boolean sole) {
        List<Out> written = new ArrayList<>(outputs);
        if (!sole && written.size() > 1 && random.nextInt(3) > 0) {
            written.remove(random.nextInt(2));
        }
        boolean total = written.stream().anyMatch(Out::total);
        boolean counts = random.nextInt(3) == 0;
        boolean free = random.nextInt(5) == 0;
        int states = 1 + random.nextInt(3);
        StringBuilder text = new StringBuilder();
        text.append(
                "\n  <<completion = \"%s\"%s>> automaton %s {\n"
                        .formatted(completion(total), free ? ", omitted = \"free\"" : "", name));
        text.append(counts ? "    variable Integer[0..1] n = 0;\n" : "");
        text.append("    state s0").append(states > 1 ? ", s1" : "");
        text.append(states > 2 ? ", s2" : "").append(";\n");
        int first = random.nextInt(states);
        text.append("    initial s%d%s;\n".formatted(first, beginning(written)));
        if (states > 1 && random.nextInt(4) == 0) {
            int second = (first + 1) % states;
            text.append("    initial s%d%s;\n".formatted(second, beginning(written)));
        }
        for (int state = 0; state < states; state++) {
            transitions(state, states, written, counts, text);
        }
        return text.append("  }\n").toString();
    }

    private String completion(boolean total) {
        int kind = random.nextInt(10);
        return kind < 4 ? "output" : kind < 6 ? "chaos" : kind < 9 || total ? "error" : "ignore";
    }

    private String beginning(List<Out> written) {
        List<String> items = new ArrayList<>();
        for (Out out : written) {
            if (out.delay == 1 && !(events && out.first.equals("--"))) {
                boolean alike = random.nextInt(8) > 0;
                items.add(out.name + " = " + (alike ? out.first : value(out.total, out.values)));
            }
        }
        return items.isEmpty() ? "" : " / {" + String.join(", ", items) + "}";
    }

    private void transitions(
            int state, int states, List<Out> written, boolean counts, StringBuilder text) {
        for (String input : inputs()) {
            int kind = random.nextInt(6);
            int count = kind < gaps ? 0 : kind >= 6 - alternatives ? 2 + random.nextInt(2) : 1;
            for (int i = 0; i < count; i++) {
                boolean next = random.nextBoolean();
                int target = next ? (state + 1) % states : random.nextInt(states);
                text.append("    s%d -> s%d%s".formatted(state, target, guard(counts)));
                text.append(" {").append(input).append(more()).append("}");
                text.append(outputs(written, counts, input)).append(";\n");
            }
        }
    }

    private List<String> inputs() {
        List<String> inputs = new ArrayList<>();
        if (random.nextInt(4) == 0) {
            inputs.add("a == ?");
        } else {
            for (int key = 0; key < keys; key++) {
                inputs.add("a == " + key);
            }
        }
        if (!totalIn && !events) {
            inputs.add("a == --");
        }
        if (flag && events) {
            inputs.add("b == ?");
        }
        return inputs;
    }

    private String more() {
        boolean latched = held && random.nextInt(3) == 0;
        boolean looks = !events && flag && random.nextInt(3) == 0;
        String port = latched ? "h" : "b";
        return latched || looks
                ? ", %s == %s"
                        .formatted(port, List.of("true", "false", "?", "--").get(random.nextInt(4)))
                : "";
    }

    private String guard(boolean counts) {
        if (!counts || random.nextInt(3) > 0) {
            return "";
        }
        return " [" + List.of("n < 1", "n > 0", "1 / n > 0", "n == a").get(random.nextInt(4)) + "]";
    }

    private String outputs(List<Out> written, boolean counts, String input) {
        List<String> items = new ArrayList<>();
        for (Out out : written) {
            if (out.total || random.nextInt(4) > 0) {
                items.add(out.name + " = " + message(out, counts, input));
            }
        }
        if (counts && random.nextInt(2) == 0) {
            items.add("n = " + List.of("n + 1", "n + 1", "0", "1 - n").get(random.nextInt(4)));
        }
        return items.isEmpty() ? "" : " / {" + String.join(", ", items) + "}";
    }

    private String message(Out out, boolean counts, String input) {
        int kind = random.nextInt(12);
        if (kind == 0) {
            return "?";
        }
        if (kind == 1 && !out.total) {
            return "--";
        }
        if (kind == 2 && counts) {
            return List.of("n", "n + 1", "1 / n").get(random.nextInt(3));
        }
        if (kind == 3 && !input.endsWith("--") && input.startsWith("a")) {
            return List.of("a", "a + 1").get(random.nextInt(2));
        }
        String one = String.valueOf(random.nextInt(out.values));
        return kind == 4 && events ? "[%s, %s]".formatted(one, random.nextInt(out.values)) : one;
    }
}
