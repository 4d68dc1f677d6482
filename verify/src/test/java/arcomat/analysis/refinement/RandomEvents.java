package arcomat.analysis.refinement;

import arcomat.check.Checks;
import arcomat.check.law.Profile;
import arcomat.lower.Lowering;
import arcomat.model.Model;
import arcomat.models.ReadModels;
import arcomat.source.Severity;
import arcomat.source.SourceFile;
import arcomat.symbols.Workspace;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;

/**
 * Event-driven components that differ a little: all completions, one automaton or two, choices,
 * ranges that may be left, latched ports. {@code Small} is a component, {@code Big} the same after
 * some edits and with one more port; each also stands alone in a composition, {@code AroundSmall},
 * and behind another part, {@code RowSmall}; in {@code HoldSmall} that part feeds the latched port.
 */
final class RandomEvents {
    private static final String MESSAGE = "Integer[0..1]";
    private static final List<String> VALUES = List.of("0", "1");
    private static final List<String> COMPLETIONS = List.of("chaos", "output", "ignore", "error");

    private final Random random;
    private final Map<String, String> files = new LinkedHashMap<>();

    RandomEvents(long seed) {
        random = new Random(seed);
        List<List<String>> automata = new ArrayList<>();
        List<List<String>> written =
                one(
                        List.of(
                                List.of(List.of("o", "p")),
                                List.of(List.of("o", "p")),
                                List.of(List.of("o"), List.of("p")),
                                List.of(List.of("o", "p"), List.of("p")),
                                List.of(List.of("o"), List.of("o"))));
        written.forEach(outputs -> automata.add(automaton("i", "k", outputs)));
        List<String> front = automaton("i", "", List.of("l"));
        component("Small", List.of(), automata);
        component("Front", List.of("l"), List.of(front));
        component("Big", List.of("j"), automata.stream().map(this::edited).toList());
        component("NewFront", List.of("j", "l"), List.of(edited(front)));
        for (String name : List.of("Small", "Big")) {
            String more = name.equals("Big") ? "j" : "";
            String part = name.equals("Big") ? "NewFront" : "Front";
            composition("Around" + name, more, name, "", more, "i -> b.i", "k -> b.k");
            composition("Row" + name, more, "Small", part, more, "f.l -> b.i", "k -> b.k");
            composition("Hold" + name, more, "Small", part, more, "i -> b.i", "f.l -> b.k");
        }
    }

    /** For messages of tests. */
    String text() {
        return String.join("\n", files.values());
    }

    Model model() {
        List<SourceFile> sources = new ArrayList<>();
        files.forEach((name, text) -> sources.add(new SourceFile("load/" + name + ".arc", text)));
        Workspace workspace = ReadModels.workspace(sources);
        Checks.run(workspace, Profile.REQUIREMENTS).stream()
                .filter(f -> f.severity() == Severity.ERROR)
                .findFirst()
                .ifPresent(
                        f -> {
                            throw new AssertionError(f + text());
                        });
        return Lowering.lower(workspace);
    }

    private boolean chance(int percent) {
        return random.nextInt(100) < percent;
    }

    private <T> T one(List<T> of) {
        return of.get(random.nextInt(of.size()));
    }

    /** The completion, what is declared, and a line for each transition. */
    private List<String> automaton(String event, String latched, List<String> outputs) {
        List<String> lines = new ArrayList<>();
        lines.add(chance(45) ? "ignore" : one(COMPLETIONS));
        String first = outputs.get(0);
        lines.add(
                "variable Integer[0..1] n = 0;\nstate s, t;\ninitial s"
                        + (chance(15) ? " / {%s = 1};".formatted(first) : ";")
                        + (chance(15) ? "\ninitial t;" : ""));
        int transitions = 2 + random.nextInt(4);
        for (int i = 0; i < transitions; i++) {
            lines.add(transition(event, latched, outputs));
        }
        for (String output : outputs) {
            lines.add("s {%s == 0} / {%s = 0};".formatted(event, output));
        }
        return lines;
    }

    private String transition(String event, String latched, List<String> outputs) {
        String guard = one(List.of("", "", " [%s >= n]".formatted(event)));
        if (!latched.isEmpty() && chance(40)) {
            guard = " [%s == %s]".formatted(latched, one(List.of("0", "1", "--")));
        }
        List<String> effects = new ArrayList<>();
        for (String output : outputs) {
            if (chance(55)) {
                effects.add(output + " = " + sent(event));
            }
        }
        if (chance(20)) {
            effects.add("n = " + one(List.of("n + 1", event, "0")));
        }
        return "%s%s {%s == %s}%s;"
                .formatted(
                        one(List.of("s", "t", "s -> t", "t -> s")),
                        guard,
                        event,
                        one(List.of("?", "?", "0", "1")),
                        effects.isEmpty() ? "" : " / {" + String.join(", ", effects) + "}");
    }

    private String sent(String event) {
        String value = one(VALUES);
        return one(List.of(value, value, event, "[%s, %s]".formatted(value, event)));
    }

    /** May do more, less, or something else; on the new port more. */
    private List<String> edited(List<String> automaton) {
        List<String> lines = new ArrayList<>(automaton);
        lines.set(0, chance(60) ? lines.get(0) : one(COMPLETIONS));
        List<String> outputs = new ArrayList<>();
        for (String each : List.of("o", "p", "l")) {
            if (lines.stream().anyMatch(line -> line.contains(each + " = "))) {
                outputs.add(each);
            }
        }
        if (chance(25) && lines.size() > 4) {
            lines.remove(2 + random.nextInt(lines.size() - 3));
        }
        for (int i = random.nextInt(3); i > 0; i--) {
            lines.add(chance(50) ? one(List.of("s", "t")) + " {j == ?};" : random("j", outputs));
        }
        if (chance(20)) {
            lines.add(random("i", outputs));
        }
        return lines;
    }

    private String random(String event, List<String> outputs) {
        return transition(event, "", outputs);
    }

    /**
     * @param own {@code j} for one more input; {@code l} for an output instead of the usual ports
     */
    private void component(String name, List<String> own, List<List<String>> automata) {
        StringBuilder text = new StringBuilder("package load;\n");
        text.append(chance(20) ? "<<capacity = \"1\">> " : "");
        text.append("component %s {\ntiming untimed;\n".formatted(name));
        text.append("port in %s i%s;\n".formatted(MESSAGE, more(own.contains("j") ? "j" : "")));
        if (own.contains("l")) {
            text.append("port out %s l;\n".formatted(MESSAGE));
        } else {
            String first = chance(30) ? " = " + one(VALUES) : "";
            text.append("port <<state%s>> in %s k".formatted(first, MESSAGE));
            text.append(", out %1$s o, out %1$s p;\n".formatted(MESSAGE));
        }
        for (int i = 0; i < automata.size(); i++) {
            List<String> lines = automata.get(i);
            text.append("<<completion = \"%s\">> automaton a%d {\n".formatted(lines.get(0), i));
            text.append(String.join("\n", lines.subList(1, lines.size()))).append("\n}\n");
        }
        files.put(name, text + "}\n");
    }

    private static String more(String port) {
        return port.isEmpty() ? "" : ", in " + MESSAGE + " " + port;
    }

    /**
     * @param front the part before the other one; empty for none
     * @param extra a port that only the new part has
     */
    private void composition(
            String name, String port, String back, String front, String extra, String... wires) {
        StringBuilder text = new StringBuilder("package load;\n");
        text.append("component %s {\ntiming untimed;\n".formatted(name));
        text.append("port in %1$s i%2$s, <<state>> in %1$s k;\n".formatted(MESSAGE, more(port)));
        text.append("port out %1$s o, out %1$s p;\n".formatted(MESSAGE));
        text.append("component %s b;\n".formatted(back));
        String reader = front.isEmpty() ? "b" : "f";
        if (!front.isEmpty()) {
            text.append("component %s f;\nconnect i -> f.i;\n".formatted(front));
        }
        if (!extra.isEmpty()) {
            text.append("connect j -> %s.j;\n".formatted(reader));
        }
        for (String wire : wires) {
            text.append("connect %s;\n".formatted(wire));
        }
        files.put(name, text + "connect b.o -> o;\nconnect b.p -> p;\n}\n");
    }
}
