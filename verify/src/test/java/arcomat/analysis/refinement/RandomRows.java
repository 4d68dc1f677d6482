package arcomat.analysis.refinement;

import arcomat.model.Component;
import arcomat.model.Model;
import arcomat.models.ReadModels;
import arcomat.semantics.Promise;
import arcomat.source.SourceFile;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.Collectors;

/**
 * Rows and rings of parts, most of them of one kind: with variables, choices, ranges that may be
 * left, inputs that are forbidden, several automata, with delay and without. Beside them stands a
 * component of which little is asked.
 */
public final class RandomRows {
    private final Random random;
    private final List<SourceFile> files = new ArrayList<>();
    private final int most;
    private final boolean errs;
    private final boolean sides;

    /** Whether what the last part sends is seen a slice later. */
    private final boolean late;

    public RandomRows(long seed) {
        this(seed, false);
    }

    /** With parts that read the others, and that nobody reads but each other. */
    static RandomRows withSides(long seed) {
        return new RandomRows(seed, true);
    }

    /** Parts of one kind in equal places, but for some, and one that looks at them all. */
    public static RandomRows equal(long seed) {
        return new RandomRows(new Random(seed));
    }

    private RandomRows(Random random) {
        this.random = random;
        sides = false;
        most = 1 + random.nextInt(2);
        errs = random.nextInt(4) == 0;
        late = false;
        kind("One", true);
        equal(2 + random.nextInt(3));
        file("Any", promise(""));
        file("Some", promise("s [i == 1] / {};\n s [i == 0] / {};\n s [i == --] / {o = 0};"));
        several();
    }

    private void equal(int count) {
        boolean ring = random.nextBoolean();
        String outside = any("connect i -> p%d.e;%n", "");
        String next = any("connect p%d.o -> p%d.y;%n", "");
        StringBuilder text = new StringBuilder();
        text.append(
                "component NAME {%n port in Integer[0..1] i, out Integer[0..%d] o;%n"
                        .formatted(most));
        text.append("component Judge j;%nconnect j.o -> o;%n".formatted());
        for (int part = 0; part < count; part++) {
            text.append("component One p%d;%n".formatted(part));
            text.append("connect p%d.o -> j.j%d;%n".formatted(part, part));
            text.append(random.nextInt(12) == 0 ? "" : outside.formatted(part));
            if (ring && random.nextInt(20) > 0) {
                text.append("connect p%d.o -> p%d.x;%n".formatted(part, (part + 1) % count));
                text.append(next.formatted(part, (part + count - 1) % count));
            }
        }
        file("Whole", text.append("}%n".formatted()).toString());
        judge(count);
    }

    /** It may tell neighbours from others, and now and then one from the others. */
    private void judge(int count) {
        int value = random.nextInt(most + 1);
        boolean pairs = random.nextInt(3) == 0;
        boolean all = !pairs && random.nextInt(3) == 0;
        int without = random.nextInt(5) == 0 ? random.nextInt(count) : -1;
        List<String> ports = new ArrayList<>();
        List<String> terms = new ArrayList<>();
        for (int part = 0; part < count; part++) {
            ports.add("in Integer[0..%d] j%d".formatted(most, part));
            String one = "j%d == %d".formatted(part, value);
            String two = " && j%d == %d".formatted((part + 1) % count, most - value);
            if (part != without) {
                terms.add("(" + one + (pairs ? two : "") + ")");
            }
        }
        file(
                "Judge",
                """
                component NAME {
                  timing instant;
                  port %s, out Integer[0..%d] o;
                  <<completion = "ignore">> automaton {
                    state s;
                    initial s;
                    s [%s] / {o = 1};
                  }
                }
                """
                        .formatted(
                                String.join(", ", ports),
                                most,
                                String.join(all ? " && " : " || ", terms)));
    }

    private RandomRows(long seed, boolean sides) {
        this.sides = sides;
        random = new Random(seed);
        most = 1 + random.nextInt(4);
        errs = random.nextInt(4) == 0;
        kind("One", true);
        boolean twoIsLate = random.nextBoolean();
        kind("Two", twoIsLate);
        late = whole().equals("One") || twoIsLate;
        file("Any", promise(""));
        file(
                "Some",
                promise("s -> t [i == 1] / {o = 0};\n t [i == 0] / {o = 1};\n t [i == 1] / {};"));
        several();
    }

    /** It may be in several states after the same messages, more and fewer of them. */
    private void several() {
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < 4 + random.nextInt(8); i++) {
            text.append(
                    " s%d -> s%d%s / {%s};%n"
                            .formatted(
                                    random.nextInt(4),
                                    random.nextInt(4),
                                    any("", " [i == 1]", " [i == 0]", " [i == --]"),
                                    any("", "o = ?", "o = ?", "o = 0", "o = --")));
        }
        boolean tolerant = random.nextBoolean();
        for (int state = 0; state < 4 && tolerant; state++) {
            String to = " s%d -> s%d".formatted(state, random.nextInt(4));
            text.append(to).append(" / {o = ?};\n").append(to).append(" / {o = --};\n");
        }
        String completion = any("output", "output", "chaos", "ignore", "error");
        file(
                "Several",
                promise(completion, "s0, s1, s2, s3", List.of("s0", "s1"), text.toString()));
    }

    public Promise whole(String name) {
        Model model = ReadModels.model(files);
        Component component = model.component("r." + name).orElseThrow();
        return Promise.of(component, List.of());
    }

    @Override
    public String toString() {
        return String.join("\n", files.stream().map(SourceFile::text).toList());
    }

    private void file(String name, String text) {
        files.add(
                new SourceFile("r/" + name + ".arc", "package r;\n" + text.replace("NAME", name)));
    }

    private String promise(String transitions) {
        return promise("output", "s, t", List.of("s"), transitions);
    }

    private String promise(
            String completion, String states, List<String> initial, String transitions) {
        String start = late ? " / {o = 0}" : "";
        return """
        component NAME {
          %s
          port in Integer[0..1] i, out Integer[0..%d] o;
          <<completion = "%s">> automaton {
            state %s;
            %s
            %s
          }
        }
        """
                .formatted(
                        late ? "" : "timing instant;",
                        most,
                        completion,
                        states,
                        initial.stream()
                                .map(state -> "initial " + state + start + ";")
                                .collect(Collectors.joining(" ")),
                        transitions);
    }

    /** It reads its neighbours x and y, and what comes from outside, e. */
    private void kind(String name, boolean delay) {
        String timing = delay ? "" : "timing instant;";
        int automata = random.nextInt(5) == 0 ? 2 : 1;
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < automata; i++) {
            text.append(automaton(automata == 1 ? "" : "a" + i, delay));
        }
        file(
                name,
                "component NAME {\n  "
                        + timing
                        + "\n  port in Integer[0..1] e, in Integer[0.."
                        + most
                        + "] x, in Integer[0.."
                        + most
                        + "] y, out Integer[0.."
                        + most
                        + "] o;\n"
                        + text
                        + "}\n");
    }

    private String automaton(String name, boolean delay) {
        int states = 1 + random.nextInt(4);
        StringBuilder text = new StringBuilder();
        String completion = errs && random.nextInt(3) == 0 ? "error" : "ignore";
        text.append(
                "  <<completion = \"%s\">> automaton %s {%n    state s0"
                        .formatted(completion, name));
        for (int state = 1; state < states; state++) {
            text.append(", s").append(state);
        }
        int range = random.nextInt(4);
        String next = "(v + 1) % " + (range + (errs ? 2 : 1));
        text.append(";%n    variable Integer[0..%d] v = 0;%n".formatted(range));
        text.append("    initial s0%s;%n".formatted(delay ? " / {o = 0}" : ""));
        for (int i = 0; i < 3 + random.nextInt(3 * states); i++) {
            text.append(
                    "    s%d -> s%d [%s] / {o = %s, v = %s};%n"
                            .formatted(
                                    random.nextInt(states),
                                    random.nextInt(states),
                                    guard(),
                                    any(
                                            "0",
                                            "0",
                                            String.valueOf(most),
                                            "1",
                                            "x",
                                            errs ? "v" : "v % 2"),
                                    any("v", "0", String.valueOf(range), next)));
        }
        return text + "  }\n";
    }

    private String guard() {
        return any(
                        "true",
                        "e == 1",
                        "e == --",
                        "x == 0",
                        "x == " + most,
                        "x == --",
                        "y > 0",
                        "y == --")
                + any("", " && v == 0", " && e != --", " || x == y");
    }

    private String any(String... texts) {
        return texts[random.nextInt(texts.length)];
    }

    private void sides(StringBuilder text, int count) {
        kind("Side", random.nextBoolean());
        int side = 1 + random.nextInt(2);
        for (int part = 0; part < side; part++) {
            text.append("  component Side q%d;%n".formatted(part));
            String read = part > 0 ? "q0" : "p" + random.nextInt(count);
            text.append("  connect %s.o -> q%d.x;%n".formatted(read, part));
            text.append("  connect i -> q%d.e;%n".formatted(part));
        }
    }

    /** The kind of the last part. */
    private String whole() {
        int count = 2 + random.nextInt(4);
        String kind = "";
        StringBuilder text = new StringBuilder();
        text.append(
                "component NAME {%n  port in Integer[0..1] i, out Integer[0..%d] o;%n"
                        .formatted(most));
        for (int part = 0; part < count; part++) {
            kind = random.nextInt(4) == 0 && part % 2 == 1 ? "Two" : "One";
            text.append("  component %s p%d;%n".formatted(kind, part));
        }
        boolean ring = random.nextBoolean();
        for (int part = 0; part < count; part++) {
            if (part > 0 || ring) {
                text.append(
                        "  connect p%d.o -> p%d.x;%n".formatted((part + count - 1) % count, part));
            }
            if (random.nextBoolean()) {
                text.append("  connect i -> p%d.e;%n".formatted(part));
            }
            if (part == 0 || random.nextInt(3) == 0) {
                text.append("  connect p0.o -> p%d.y;%n".formatted(part));
            }
        }
        text.append("  connect p%d.o -> o;%n".formatted(count - 1));
        if (sides) {
            sides(text, count);
        }
        text.append("}\n");
        file("Whole", text.toString());
        return kind;
    }
}
