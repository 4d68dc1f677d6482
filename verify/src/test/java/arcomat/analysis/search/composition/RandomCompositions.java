package arcomat.analysis.search.composition;

import arcomat.check.Checks;
import arcomat.check.law.Profile;
import arcomat.lower.Lowering;
import arcomat.model.Component;
import arcomat.models.ReadModels;
import arcomat.source.Severity;
import arcomat.source.SourceFile;
import arcomat.symbols.Workspace;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/**
 * Event-driven compositions of a few small parts: short queues, latched ports, fan-out, choices,
 * ranges that may be left, and, if asked for, circles. No part leaves a message open.
 */
final class RandomCompositions {
    private static final List<String> VALUES = List.of("0", "1", "2");

    private final Random random;
    private final boolean circles;
    private final List<String> files = new ArrayList<>();
    private Random dropped;
    private final List<List<String>> inputs = new ArrayList<>();

    private RandomCompositions(long seed, boolean circles) {
        this.random = new Random(seed);
        this.circles = circles;
    }

    static Component of(long seed, boolean circles) {
        return new RandomCompositions(seed, circles).component();
    }

    /** The same, but one transition of a part is missing. */
    static Component edited(long seed) {
        RandomCompositions edited = new RandomCompositions(seed, false);
        edited.dropped = new Random(seed);
        return edited.component();
    }

    private Component component() {
        int count = 2 + random.nextInt(2);
        for (int part = 0; part < count; part++) {
            files.add(part(part));
        }
        files.add(whole(count));
        if (dropped != null) {
            int part = dropped.nextInt(count);
            files.set(part, withoutOne(files.get(part)));
        }
        List<SourceFile> sources = new ArrayList<>();
        for (int i = 0; i < files.size(); i++) {
            String name = i < count ? "P" + i : "Whole";
            sources.add(new SourceFile("load/" + name + ".arc", files.get(i)));
        }
        Workspace workspace = ReadModels.workspace(sources);
        Checks.run(workspace, Profile.REQUIREMENTS).stream()
                .filter(f -> f.severity() == Severity.ERROR)
                .findFirst()
                .ifPresent(
                        f -> {
                            throw new AssertionError(f + String.join("\n", files));
                        });
        return Lowering.lower(workspace).component("load.Whole").orElseThrow();
    }

    private String withoutOne(String part) {
        List<String> lines = new ArrayList<>(part.lines().toList());
        List<String> transitions =
                lines.stream()
                        .filter(line -> line.contains("{x ==") || line.contains("{w =="))
                        .toList();
        lines.remove(transitions.get(dropped.nextInt(transitions.size())));
        return String.join("\n", lines) + "\n";
    }

    private boolean chance(int percent) {
        return random.nextInt(100) < percent;
    }

    private String one(List<String> of) {
        return of.get(random.nextInt(of.size()));
    }

    private String part(int number) {
        List<String> events = new ArrayList<>(List.of("x"));
        List<String> own = new ArrayList<>(List.of("x"));
        StringBuilder text = new StringBuilder("package load;\n");
        if (chance(60)) {
            text.append("<<capacity = \"%d\">> ".formatted(1 + random.nextInt(3)));
        }
        text.append("component P%d {\ntiming untimed;\n".formatted(number));
        text.append("port in Integer[0..2] x, out Integer[0..2] y, out Integer[0..2] z;\n");
        if (chance(40)) {
            text.append("port in Integer[0..2] w;\n");
            events.add("w");
            own.add("w");
        }
        boolean latched = chance(40);
        if (latched) {
            text.append("port <<state>> in Integer[0..2] h;\n");
            own.add("h");
        }
        inputs.add(own);
        text.append("<<completion = \"%s\">> automaton {\n".formatted(completion()));
        text.append("variable Integer[0..2] n = 0;\nstate s, t;\ninitial s");
        text.append(chance(30) ? " / {y = 1};\n" : ";\n");
        if (chance(20)) {
            text.append("initial t;\n");
        }
        int transitions = 2 + random.nextInt(3);
        for (int i = 0; i < transitions; i++) {
            text.append(transition(one(events), latched));
        }
        return text + "}\n}\n";
    }

    private String completion() {
        return chance(10) ? "error" : "ignore";
    }

    private String transition(String event, boolean latched) {
        String states = one(List.of("s", "t", "s -> t", "t -> s"));
        String guard =
                one(
                        List.of(
                                "",
                                "",
                                " [%s > n]".formatted(event),
                                latched ? " [h == %s]".formatted(one(VALUES)) : "",
                                latched ? " [h == --]" : ""));
        String item =
                event + " == " + one(List.of("?", "?", "alt {0, 1}", one(VALUES), one(VALUES)));
        List<String> effects = new ArrayList<>();
        if (chance(60)) {
            effects.add("y = " + sent(event, latched && guard.contains("h == ") ? "1" : event));
        }
        if (chance(40)) {
            effects.add("z = " + sent(event, "n"));
        }
        if (chance(15)) {
            effects.add("n = n + 1");
        } else if (chance(15)) {
            effects.add("n = " + event);
        }
        return "%s%s {%s}%s;\n"
                .formatted(
                        states,
                        guard,
                        item,
                        effects.isEmpty() ? "" : " / {" + String.join(", ", effects) + "}");
    }

    private String sent(String event, String other) {
        return one(List.of(one(VALUES), event, other, "[%s, %s]".formatted(one(VALUES), event)));
    }

    private String whole(int count) {
        StringBuilder text = new StringBuilder("package load;\ncomponent Whole {\n");
        text.append("timing untimed;\nport in Integer[0..2] i, in Integer[0..2] j,\n");
        text.append("<<state>> in Integer[0..2] k,\n");
        text.append("out Integer[0..2] o, out Integer[0..2] p, out Integer[0..2] q;\n");
        List<String> sources = new ArrayList<>(List.of("i", "j"));
        List<String> outputs = new ArrayList<>();
        for (int part = 0; part < count; part++) {
            text.append("component P%d p%d;\n".formatted(part, part));
            outputs.add("p%d.y".formatted(part));
            outputs.add("p%d.z".formatted(part));
        }
        for (int part = 0; part < count; part++) {
            List<String> all = new ArrayList<>(sources);
            all.addAll(circles ? outputs : outputs.subList(0, 2 * part));
            all.addAll(circles ? outputs : outputs.subList(0, 2 * part));
            for (String input : inputs.get(part)) {
                String source = input.equals("h") && chance(50) ? "k" : one(all);
                text.append("connect %s -> p%d.%s;\n".formatted(source, part, input));
            }
        }
        text.append("connect %s -> o;\n".formatted(one(outputs)));
        text.append("connect %s -> p;\n".formatted(outputs.get(outputs.size() - 2)));
        text.append("connect %s -> q;\n".formatted(chance(10) ? "i" : one(outputs)));
        return text + "}\n";
    }

    /** For messages of tests. */
    static String text(long seed, boolean circles) {
        RandomCompositions again = new RandomCompositions(seed, circles);
        again.component();
        return String.join("\n", again.files);
    }
}
