package arcomat.benchmarks.analysis;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/** Models to be compared, as text. */
final class Texts {
    private static final String LETTERS =
            "package load;\n"
                    + "classdiagram Types { enum Letter {a, b, c, d;} enum Answer {x, y, z;} }\n";

    private Texts() {}

    static String types() {
        return LETTERS;
    }

    /**
     * A nondeterministic automaton: on each letter two transitions out of every state, to any
     * states, with any answers.
     *
     * @param kept percentage of second transitions that are kept; less is a refinement
     */
    static String random(String name, int states, int kept, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        SplittableRandom choice = new SplittableRandom(seed + 1);
        List<String> transitions = new ArrayList<>();
        for (int state = 0; state < states; state++) {
            for (char letter = 'a'; letter <= 'd'; letter++) {
                for (int second = 0; second < 2; second++) {
                    String transition =
                            "s%d -> s%d {i == %s} / {o = %s};"
                                    .formatted(
                                            state,
                                            random.nextInt(states),
                                            letter,
                                            "xy".charAt(random.nextInt(2)));
                    if (second == 0 || choice.nextInt(100) < kept) {
                        transitions.add(transition);
                    }
                }
            }
        }
        return component(
                name,
                "port <<total>> in Letter i, out Answer o;",
                "output",
                states(states) + "initial s0;",
                transitions);
    }

    /** Counts the ticks, round and round, and answers with what came in. */
    static String counter(String name, int size) {
        List<String> transitions = new ArrayList<>();
        for (int state = 0; state < size; state++) {
            transitions.add("s%d -> s%d {i == a} / {o = x};".formatted(state, (state + 1) % size));
        }
        return component(
                name,
                "port <<total>> in Letter i, out Answer o;",
                "ignore",
                states(size) + "initial s0;",
                transitions);
    }

    /**
     * An automaton with three inputs and three outputs that tells many of their letters apart.
     *
     * @param skipped percentage of transitions that are left out; more is a requirement
     */
    static String wide(String name, int states, int skipped, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        SplittableRandom choice = new SplittableRandom(seed + 1);
        List<String> transitions = new ArrayList<>();
        for (int state = 0; state < states; state++) {
            for (int t = 0; t < 4; t++) {
                String transition =
                        "s%d -> s%d {i == %s, j == %s, k == %s} / {o = %s, p = %s, q = %s};"
                                .formatted(
                                        state,
                                        t == 0 ? (state + 1) % states : random.nextInt(states),
                                        "abcd".charAt(t),
                                        letter(random),
                                        letter(random),
                                        answer(random),
                                        answer(random),
                                        answer(random));
                if (t == 0 || choice.nextInt(100) >= skipped) {
                    transitions.add(transition);
                }
            }
        }
        return component(
                name,
                "port in Letter i, in Letter j, in Letter k, out Answer o, out Answer p, out Answer"
                        + " q;",
                "chaos",
                states(states) + "initial s0;",
                transitions);
    }

    private static char letter(SplittableRandom random) {
        return "abcd".charAt(random.nextInt(4));
    }

    private static char answer(SplittableRandom random) {
        return "xyz".charAt(random.nextInt(3));
    }

    /** A stage of a pipeline; the refining one decides what the other leaves open. */
    static String stage(String name, boolean decided) {
        List<String> transitions = new ArrayList<>();
        for (char letter = 'a'; letter <= 'd'; letter++) {
            transitions.add("s {i == %s} / {o = %s};".formatted(letter, letter));
            if (!decided) {
                transitions.add("s {i == %s} / {o = a};".formatted(letter));
            }
        }
        return component(
                name,
                "port in Letter i, out Letter o;",
                "ignore",
                "state s; initial s;",
                transitions);
    }

    /** So many stages in a row. */
    static String pipeline(String name, String stage, int count) {
        StringBuilder text = new StringBuilder("package load;\ncomponent ");
        text.append(name).append(" {\n    port in load.Types.Letter i, out load.Types.Letter o;\n");
        for (int i = 0; i < count; i++) {
            text.append("    component ").append(stage).append(" part").append(i).append(";\n");
            String sender = i == 0 ? "i" : "part" + (i - 1) + ".o";
            text.append("    connect ").append(sender).append(" -> part").append(i).append(".i;\n");
        }
        return text.append("    connect part").append(count - 1).append(".o -> o;\n}\n").toString();
    }

    /**
     * Twelve requirements that count ticks of their own and then have a say in one output; the
     * first and the last cannot be kept together.
     */
    static String requirements() {
        StringBuilder ports = new StringBuilder("port ");
        StringBuilder automata = new StringBuilder();
        for (int i = 0; i < 12; i++) {
            ports.append("in Boolean tick").append(i).append(", ");
            int last = 6 + i % 5;
            automata.append("    <<completion = \"output\">> automaton counter%d {\n".formatted(i))
                    .append("        variable Integer[0..%d] n = 0;\n".formatted(last))
                    .append("        state s; initial s / {level = 1};\n");
            for (int level = 1; level <= 2; level++) {
                automata.append(
                        "        s [n < %d] {tick%d == true} / {n = n + 1, level = %d};\n"
                                .formatted(last, i, level));
                boolean refused = i == 0 && level == 1 || i == 11 && level == 2;
                if (!refused) {
                    automata.append(
                            "        s [n == %d] {tick%d == true} / {n = 0, level = %d};\n"
                                    .formatted(last, i, level));
                }
            }
            automata.append("    }\n");
        }
        return "package load;\ncomponent Counters {\n    %sout Integer[1..2] level;\n%s}\n"
                .formatted(ports, automata);
    }

    private static String states(int count) {
        StringBuilder states = new StringBuilder("state s0");
        for (int i = 1; i < count; i++) {
            states.append(", s").append(i);
        }
        return states.append("; ").toString();
    }

    private static String component(
            String name, String ports, String completion, String states, List<String> transitions) {
        return "package load;\nimport load.Types.*;\ncomponent %s {\n    %s\n    <<completion = \"%s\">> automaton {\n        %s\n        %s\n    }\n}\n"
                .formatted(name, ports, completion, states, String.join("\n        ", transitions));
    }
}
