package arcomat.analysis.search.packed;

import arcomat.check.Checks;
import arcomat.check.law.Profile;
import arcomat.lower.Lowering;
import arcomat.model.Model;
import arcomat.models.ReadModels;
import arcomat.semantics.Promise;
import arcomat.source.Severity;
import arcomat.source.SourceFile;
import arcomat.symbols.Workspace;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;

/**
 * Event-driven compositions of a few parts, {@code Whole}: short queues, fan-out, latched ports
 * that are fed from inside, by events and by latched inputs, several messages for an event,
 * choices, ranges that may be left, messages that are left open, now and then circles and several
 * automata. Beside them components of which little is asked: {@code Any}, {@code Some} and {@code
 * Strict}.
 */
public final class RandomEventNetworks {
    private static final String MESSAGE = "Integer[0..2]";
    private static final List<String> VALUES = List.of("0", "1", "2");

    private final Random random;
    private final boolean circles;
    private final boolean open;
    private final boolean latched;
    private final Map<String, String> files = new LinkedHashMap<>();
    private final List<List<String>> inputs = new ArrayList<>();
    private final Model model;

    public RandomEventNetworks(long seed) {
        random = new Random(seed);
        circles = chance(10);
        open = chance(25);
        latched = chance(40);
        int count = 2 + random.nextInt(3);
        for (int part = 0; part < count; part++) {
            part("P" + part);
        }
        whole(count);
        right("Any", List.of("s {i == ?};"), "output");
        right("Some", some(), one(List.of("output", "output", "ignore", "chaos")));
        right("Strict", some(), one(List.of("ignore", "error")));
        model = model();
    }

    public Promise promise(String name) {
        return Promise.of(model.component("load." + name).orElseThrow(), List.of());
    }

    private Model model() {
        List<SourceFile> sources = new ArrayList<>();
        files.forEach((name, text) -> sources.add(new SourceFile("load/" + name + ".arc", text)));
        Workspace workspace = ReadModels.workspace(sources);
        Checks.run(workspace, Profile.REQUIREMENTS).stream()
                .filter(finding -> finding.severity() == Severity.ERROR)
                .findFirst()
                .ifPresent(
                        finding -> {
                            throw new AssertionError(finding + toString());
                        });
        return Lowering.lower(workspace);
    }

    @Override
    public String toString() {
        return String.join("\n", files.values());
    }

    private boolean chance(int percent) {
        return random.nextInt(100) < percent;
    }

    private <T> T one(List<T> of) {
        return of.get(random.nextInt(of.size()));
    }

    private void part(String name) {
        List<String> events = new ArrayList<>(List.of("x"));
        StringBuilder text = new StringBuilder("package load;\n");
        text.append(chance(60) ? "<<capacity = \"%d\">> ".formatted(1 + random.nextInt(3)) : "");
        text.append("component %s {\ntiming untimed;\n".formatted(name));
        text.append("port in %1$s x, out %1$s y, out %1$s z;\n".formatted(MESSAGE));
        if (chance(40)) {
            text.append("port in %s w;\n".formatted(MESSAGE));
            events.add("w");
        }
        List<String> own = new ArrayList<>(events);
        if (chance(50)) {
            String first = chance(30) ? " = " + one(VALUES) : "";
            text.append("port <<state%s>> in %s h;\n".formatted(first, MESSAGE));
            own.add("h");
            if (chance(40)) {
                text.append("port <<state>> in %s g;\n".formatted(MESSAGE));
                own.add("g");
            }
        }
        inputs.add(own);
        int automata = chance(12) ? 2 : 1;
        for (int i = 0; i < automata; i++) {
            text.append(automaton(i, events, own.subList(events.size(), own.size())));
        }
        files.put(name, text + "}\n");
    }

    private String automaton(int number, List<String> events, List<String> held) {
        String completion =
                open
                        ? one(List.of("ignore", "ignore", "output", "chaos"))
                        : chance(10) ? "error" : "ignore";
        StringBuilder text = new StringBuilder();
        text.append("<<completion = \"%s\">> automaton a%d {\n".formatted(completion, number));
        text.append("variable %s n = 0;\nstate s, t;\ninitial s".formatted(MESSAGE));
        text.append(chance(12) ? " / {y = 1};\n" : ";\n");
        text.append(chance(15) ? "initial t;\n" : "");
        int transitions = 3 + random.nextInt(3);
        for (int i = 0; i < transitions; i++) {
            text.append(transition(one(events), held));
        }
        return text + "}\n";
    }

    private String transition(String event, List<String> held) {
        String guard = one(List.of("", "", " [%s > n]".formatted(event)));
        if (!held.isEmpty() && chance(50)) {
            String value = one(List.of("0", "1", "--", "n", event));
            guard = " [%s == %s]".formatted(one(held), value);
        }
        String match = event + " == " + one(List.of("?", "?", "alt {0, 1}", "0", "1", "2"));
        List<String> effects = new ArrayList<>();
        if (chance(70)) {
            effects.add("y = " + sent(event));
        }
        if (chance(40)) {
            effects.add("z = " + (open && chance(20) ? "?" : sent(event)));
        }
        if (chance(30)) {
            effects.add("n = " + one(List.of("n + 1", "(n + 1) % 3", event, event)));
        }
        return "%s%s {%s}%s;\n"
                .formatted(
                        one(List.of("s", "t", "s -> t", "t -> s")),
                        guard,
                        match,
                        effects.isEmpty() ? "" : " / {" + String.join(", ", effects) + "}");
    }

    private String sent(String event) {
        String value = one(VALUES);
        String several = "[%s, %s]".formatted(value, event);
        return one(List.of(value, event, event, "n", several));
    }

    private void whole(int count) {
        StringBuilder text = new StringBuilder("package load;\ncomponent Whole {\n");
        text.append("timing untimed;\n").append(ports());
        List<String> outputs = new ArrayList<>();
        for (int part = 0; part < count; part++) {
            text.append("component P%d p%d;\n".formatted(part, part));
            outputs.add("p%d.y".formatted(part));
            outputs.add("p%d.z".formatted(part));
        }
        for (int part = 0; part < count; part++) {
            List<String> sources = new ArrayList<>(List.of("i", "j"));
            List<String> before = circles ? outputs : outputs.subList(0, 2 * part);
            sources.addAll(before);
            sources.addAll(before);
            for (String input : inputs.get(part)) {
                String source = latched && "hg".contains(input) && chance(60) ? "k" : one(sources);
                text.append("connect %s -> p%d.%s;\n".formatted(source, part, input));
            }
        }
        text.append("connect %s -> o;\n".formatted(one(outputs)));
        text.append("connect %s -> p;\n".formatted(chance(10) ? "i" : one(outputs)));
        files.put("Whole", text + "}\n");
    }

    private String ports() {
        String held = latched ? "port <<state>> in %s k;\n".formatted(MESSAGE) : "";
        return held + "port in %1$s i, in %1$s j, out %1$s o, out %1$s p;\n".formatted(MESSAGE);
    }

    private List<String> some() {
        List<String> lines = new ArrayList<>();
        for (String event : List.of("i", "j")) {
            for (String value : VALUES) {
                int answers = 1 + random.nextInt(3);
                for (int i = 0; i < answers && chance(85); i++) {
                    String to = chance(20) ? "t" : "s";
                    lines.add("s -> %s {%s == %s}%s;".formatted(to, event, value, answer()));
                    lines.add("t {%s == ?}%s;".formatted(event, answer()));
                }
            }
        }
        return lines;
    }

    private String answer() {
        String answer = one(List.of("o = 0", "o = 1", "o = ?", "p = ?", "o = ?, p = ?", ""));
        return answer.isEmpty() ? "" : " / {" + answer + "}";
    }

    private void right(String name, List<String> transitions, String completion) {
        files.put(
                name,
                """
                package load;
                component %s {
                timing untimed;
                %s
                <<completion = "%s">> automaton {
                state s, t;
                initial s;
                initial t / {o = ?};
                %s
                }
                }
                """
                        .formatted(name, ports(), completion, String.join("\n", transitions)));
    }
}
