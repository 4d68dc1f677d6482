package arcomat.analysis.refinement;

import arcomat.check.Checks;
import arcomat.check.law.Profile;
import arcomat.lower.Lowering;
import arcomat.model.Component;
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
 * A requirement and what it watches, in text: slices or events, all completions, one automaton or
 * two, ranges that may be left, divisions, total and latched ports, ports that stay free. What is
 * watched is the requirement after some edits, perhaps with other delays and one more input, alone
 * or with a part behind it that passes on what it sends.
 */
final class RandomWatched {
    private final Random random;
    private final boolean events;
    private final boolean totalIn;
    private final boolean totalOut;
    private final Map<String, String> files = new LinkedHashMap<>();

    /** One automaton, line by line. */
    private record Lines(
            String completion,
            boolean free,
            List<String> outputs,
            List<String> initials,
            List<String> transitions) {}

    RandomWatched(long seed) {
        random = new Random(seed);
        events = chance(35);
        totalIn = !events && chance(25);
        totalOut = !events && chance(15);
        Map<String, Integer> delays = delays();
        List<Lines> required = new ArrayList<>();
        List<List<String>> interfaces =
                totalOut
                        ? List.of(List.of("yz"), List.of("yz", "yz"))
                        : List.of(
                                List.of("yz"),
                                List.of("yz"),
                                List.of("y", "z"),
                                List.of("y", "y"),
                                List.of("yz", "y"),
                                List.of("y"));
        for (String outputs : one(interfaces)) {
            required.add(automaton(List.of(outputs.split(""))));
        }
        component("Required", "", delays, required);
        List<Lines> own = required.stream().map(this::edited).toList();
        if (chance(70)) {
            component(
                    "Running",
                    !events && chance(30) ? "e" : "",
                    chance(70) ? delays : delays(),
                    own);
        } else {
            component("Part", "", chance(50) ? delays : delays(), own);
            relay(delays());
            composition();
        }
    }

    private Map<String, Integer> delays() {
        int y = random.nextInt(2);
        return Map.of("y", y, "z", totalOut ? 1 : chance(70) ? y : 1 - y);
    }

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

    static Component component(Model model, String name) {
        return model.component("load." + name).orElseThrow();
    }

    private boolean chance(int percent) {
        return random.nextInt(100) < percent;
    }

    private <T> T one(List<T> of) {
        return of.get(random.nextInt(of.size()));
    }

    private String completion() {
        String some = one(List.of("chaos", "output", "ignore", "error"));
        return totalOut && some.equals("ignore") ? "output" : some;
    }

    private Lines automaton(List<String> outputs) {
        List<String> initials = new ArrayList<>(List.of("s"));
        if (chance(20)) {
            initials.add("t");
        }
        List<String> transitions = new ArrayList<>();
        for (int i = 3 + random.nextInt(5); i > 0; i--) {
            transitions.add(transition("", outputs));
        }
        return new Lines(completion(), chance(20), outputs, initials, transitions);
    }

    /** With one port for every output, that something is to be sent there. */
    private String transition(String extra, List<String> outputs) {
        String guard = one(List.of("", "", "", " [n > 0]", " [4 / n > 2]"));
        List<String> effects = new ArrayList<>();
        for (String output : outputs) {
            if (output.equals("z") ? totalOut || chance(50) : chance(65)) {
                effects.add(output + " = " + sent(output));
            }
        }
        if (chance(25)) {
            effects.add("n = " + one(List.of("n + 1", "n - 1", "0", "2")));
        }
        return "%s%s%s%s;"
                .formatted(
                        one(List.of("s", "t", "s -> t", "t -> s")),
                        guard,
                        input(extra),
                        effects.isEmpty() ? "" : " / {" + String.join(", ", effects) + "}");
    }

    private String input(String extra) {
        String a = one(List.of("a == 0", "a == 1", "a == ?", "a == alt {0, 2}"));
        if (events) {
            String latched = chance(25) ? one(List.of(", b == true", ", b == --")) : "";
            return " {" + (extra.isEmpty() ? a : extra + " == true") + latched + "}";
        }
        String silent = totalIn ? "a == 2" : "a == --";
        String b = one(List.of("", "", "b == true", "b == --"));
        String first = one(List.of(a, a, silent, ""));
        String both = first + (first.isEmpty() || b.isEmpty() ? "" : ", ") + b;
        String all = extra.isEmpty() ? both : extra + " == true";
        return all.isEmpty() ? "" : " {" + all + "}";
    }

    private String sent(String output) {
        if (output.equals("z")) {
            return one(List.of("true", "false", "?"));
        }
        String list = events && chance(20) ? "[1, n]" : "1";
        return one(List.of("0", list, "n", "n + 1", "?"));
    }

    private Lines edited(Lines lines) {
        List<String> transitions = new ArrayList<>(lines.transitions);
        for (int edits = random.nextInt(4); edits > 0; edits--) {
            int place = random.nextInt(transitions.size());
            switch (random.nextInt(4)) {
                case 0 -> transitions.add(transition("", lines.outputs));
                case 1 -> transitions.set(place, transition("", lines.outputs));
                case 2 -> transitions.add(transitions.get(place));
                default -> transitions.add(place, transition("", lines.outputs));
            }
        }
        if (chance(30) && transitions.size() > 1) {
            transitions.remove(random.nextInt(transitions.size()));
        }
        String completion = chance(75) ? lines.completion : completion();
        return new Lines(completion, lines.free, lines.outputs, lines.initials, transitions);
    }

    private void component(
            String name, String extra, Map<String, Integer> delays, List<Lines> automata) {
        StringBuilder text = new StringBuilder(head(name, extra, delays));
        for (int i = 0; i < automata.size(); i++) {
            Lines lines = automata.get(i);
            text.append(
                    "<<completion = \"%s\"%s>> automaton a%d {\n"
                            .formatted(
                                    lines.completion, lines.free ? ", omitted = \"free\"" : "", i));
            text.append("variable Integer[0..2] n = 1;\nstate s, t;\n");
            for (String state : lines.initials) {
                text.append("initial " + state + opening(lines, delays) + ";\n");
            }
            lines.transitions.forEach(each -> text.append(each).append('\n'));
            if (!extra.isEmpty() && chance(50)) {
                text.append(transition(extra, lines.outputs)).append('\n');
            }
            text.append("}\n");
        }
        files.put(name, text + "}\n");
    }

    private String opening(Lines lines, Map<String, Integer> delays) {
        List<String> sends = new ArrayList<>();
        if (lines.outputs.contains("z") && totalOut) {
            sends.add("z = true");
        }
        if (lines.outputs.contains("y") && (events || delays.get("y") == 1)) {
            sends.add("y = " + lines.initials.size());
        }
        return sends.isEmpty() ? "" : " / {" + String.join(", ", sends) + "}";
    }

    private String head(String name, String extra, Map<String, Integer> delays) {
        String b = events ? "<<state>> in Boolean b" : "in Boolean b";
        return "package load;\ncomponent %s {\n%s"
                        .formatted(name, events ? "timing untimed;\n" : "")
                + "port %sin Integer[0..2] a, %s%s;\n"
                        .formatted(
                                totalIn ? "<<total>> " : "",
                                b,
                                extra.isEmpty() ? "" : ", in Boolean " + extra)
                + "port %sout Integer[0..2] y, %s%sout Boolean z;\n"
                        .formatted(
                                delay("y", delays),
                                totalOut ? "<<total>> " : "",
                                totalOut ? "" : delay("z", delays));
    }

    private String delay(String port, Map<String, Integer> delays) {
        return !events && delays.get(port) == 0 ? "<<delay = \"0\">> " : "";
    }

    /** Passes {@code y} on, at once or a slice later. */
    private void relay(Map<String, Integer> delays) {
        files.put(
                "Relay",
                "package load;\ncomponent Relay {\n%s".formatted(events ? "timing untimed;\n" : "")
                        + "port in Integer[0..2] y, %sout Integer[0..2] o;\n"
                                .formatted(delay("y", delays))
                        + "<<completion = \"ignore\">> automaton {\nstate s;\ninitial s;\n"
                        + "s {y == ?} / {o = y};\n}\n}\n");
    }

    private void composition() {
        files.put(
                "Running",
                head("Running", "", Map.of("y", 1, "z", 1))
                        + "component Part p;\ncomponent Relay r;\n"
                        + "connect a -> p.a;\nconnect b -> p.b;\nconnect p.y -> r.y;\n"
                        + "connect r.o -> y;\nconnect p.z -> z;\n}\n");
    }
}
