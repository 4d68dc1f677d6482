package arcomat.simulate;

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
 * Time-synchronous models of one to four parts, as text: all completions, delays in mixture,
 * several automata, ranges and divisions that go wrong, outputs left open, fan-out to parts and to
 * the outside. The same seed gives the same model.
 */
public final class RandomSliceModels {
    private static final List<String> VALUES = List.of("0", "1", "2");

    /** A port of a part, and whether its messages have no delay. */
    private record Sender(String name, boolean instant) {}

    private final Random random;
    private final boolean large;
    private final List<String> files = new ArrayList<>();
    private final List<List<String>> inputs = new ArrayList<>();
    private final List<List<Sender>> outputs = new ArrayList<>();

    private RandomSliceModels(long seed, boolean large) {
        this.random = new Random(seed);
        this.large = large;
    }

    /**
     * A model that passes the checks.
     *
     * @param large whether ports between the parts may carry any number
     */
    public static Component of(long seed, boolean large) {
        return lowered(files(seed, large));
    }

    /**
     * The same after a small change: a transition less, or another completion.
     *
     * @param change which one
     */
    public static Component edited(long seed, long change) {
        List<String> files = new ArrayList<>(files(seed, false));
        Random random = new Random(change);
        int part = random.nextInt(files.size() - 1);
        List<String> lines = new ArrayList<>(files.get(part).lines().toList());
        List<Integer> places = new ArrayList<>();
        boolean completion = random.nextInt(3) == 0;
        String pattern = completion ? "<<completion.*" : "[st]( -> [st])?[ ;].*";
        for (int i = 0; i < lines.size(); i++) {
            if (lines.get(i).matches(pattern)) {
                places.add(i);
            }
        }
        int place = places.get(random.nextInt(places.size()));
        String other = List.of("chaos", "output", "ignore", "error").get(random.nextInt(4));
        lines.set(
                place,
                completion ? lines.get(place).replaceFirst("\"[a-z]+\"", "\"" + other + "\"") : "");
        files.set(part, String.join("\n", lines) + "\n");
        return lowered(files);
    }

    /** Its text, for messages of tests. */
    public static String text(long seed, boolean large) {
        return String.join("\n", files(seed, large));
    }

    private static List<String> files(long seed, boolean large) {
        for (long attempt = 0; ; attempt++) {
            RandomSliceModels models = new RandomSliceModels(seed * 1_000 + attempt, large);
            List<String> files = models.write();
            if (isFine(files)) {
                return files;
            }
        }
    }

    private static Workspace workspace(List<String> files) {
        List<SourceFile> sources = new ArrayList<>();
        for (int i = 0; i < files.size(); i++) {
            String name = i + 1 < files.size() ? "P" + i : "Whole";
            sources.add(new SourceFile("load/" + name + ".arc", files.get(i)));
        }
        return ReadModels.workspace(sources);
    }

    /** Not so with messages that circle without delay. */
    private static boolean isFine(List<String> files) {
        return Checks.run(workspace(files), Profile.REQUIREMENTS).stream()
                .filter(finding -> finding.severity() == Severity.ERROR)
                .peek(
                        finding -> {
                            if (!finding.code().equals("ARC0124")) {
                                throw new AssertionError(finding + String.join("\n", files));
                            }
                        })
                .findAny()
                .isEmpty();
    }

    private static Component lowered(List<String> files) {
        return Lowering.lower(workspace(files)).component("load.Whole").orElseThrow();
    }

    private boolean chance(int percent) {
        return random.nextInt(100) < percent;
    }

    private <T> T one(List<T> of) {
        return of.get(random.nextInt(of.size()));
    }

    private String type() {
        return large && chance(40) ? "Integer" : "Integer[0..2]";
    }

    private List<String> write() {
        int count = 1 + random.nextInt(4);
        String inside = type();
        for (int part = 0; part < count; part++) {
            files.add(part(part, inside));
        }
        files.add(whole(count, inside));
        return files;
    }

    private String part(int number, String type) {
        List<String> reads = new ArrayList<>(List.of("x"));
        List<Sender> sends = new ArrayList<>();
        StringBuilder text = new StringBuilder("package load;\n");
        text.append("component P%d {\nport in %s x".formatted(number, type));
        if (chance(40)) {
            text.append(", in %s w".formatted(type));
            reads.add("w");
        }
        for (String port : chance(50) ? List.of("y", "z") : List.of("y")) {
            boolean instant = chance(45);
            text.append(instant ? ", <<delay = \"0\">>" : ",");
            text.append(" out %s %s".formatted(type, port));
            sends.add(new Sender(port, instant));
        }
        text.append(";\n");
        inputs.add(reads);
        outputs.add(sends);
        int automata = chance(30) ? 2 : 1;
        List<Sender> late = sends.stream().filter(each -> !each.instant).toList();
        String begun = block(effects(late, VALUES));
        for (int i = 0; i < automata; i++) {
            text.append(automaton("A" + i, reads, sends, begun));
        }
        return text + "}\n";
    }

    /**
     * An automaton.
     *
     * @param begun what all automata of the component send in the beginning
     */
    private String automaton(String name, List<String> reads, List<Sender> sends, String begun) {
        boolean free = chance(15);
        StringBuilder text = new StringBuilder();
        String completion =
                one(List.of("chaos", "output", "output", "ignore", "ignore", "ignore", "error"));
        text.append(
                "<<completion = \"%s\"%s>> automaton %s {\n"
                        .formatted(completion, free ? ", omitted = \"free\"" : "", name));
        text.append("variable Integer[0..2] n = 0;\nstate s, t;\n");
        List<Sender> late = sends.stream().filter(each -> !each.instant).toList();
        text.append("initial s%s;\n".formatted(begun));
        if (chance(15)) {
            text.append("initial t%s;\n".formatted(block(effects(late, VALUES))));
        }
        int transitions = 2 + random.nextInt(4);
        for (int i = 0; i < transitions; i++) {
            text.append(transition(reads, sends));
        }
        return text + "}\n";
    }

    private static String block(List<String> items) {
        return items.isEmpty() ? "" : " / {" + String.join(", ", items) + "}";
    }

    private String transition(List<String> reads, List<Sender> sends) {
        String states = one(List.of("s", "t", "s -> t", "t -> s"));
        String port = one(reads);
        String guard =
                one(
                        List.of(
                                "",
                                "",
                                "",
                                " [%s > n]".formatted(port),
                                " [%s == n]".formatted(port),
                                " [2 / %s > 0]".formatted(port),
                                " [n < 2]"));
        List<String> items = new ArrayList<>();
        boolean known = false;
        for (String each : reads) {
            if (chance(70)) {
                String asked = one(List.of("?", "0", "1", "2", "alt {0, 1}", "--"));
                items.add(each + " == " + asked);
                known |= each.equals(port) && !asked.equals("--");
            }
        }
        List<String> values = new ArrayList<>(List.of("0", "1", "2", "n", "?"));
        if (known) {
            values.addAll(List.of(port, port, port + " + 1"));
        }
        List<String> effects = effects(sends, values);
        if (chance(25)) {
            effects.add(one(known ? List.of("n = n + 1", "n = " + port) : List.of("n = n + 1")));
        }
        String input = items.isEmpty() ? "" : " {" + String.join(", ", items) + "}";
        return states + guard + input + block(effects) + ";\n";
    }

    private List<String> effects(List<Sender> sends, List<String> values) {
        List<String> effects = new ArrayList<>();
        for (Sender each : sends) {
            if (chance(60)) {
                effects.add(each.name + " = " + one(values));
            }
        }
        return effects;
    }

    private String whole(int count, String inside) {
        StringBuilder text = new StringBuilder("package load;\ncomponent Whole {\n");
        String outside = inside.equals("Integer") ? inside : one(List.of(inside, "Integer[0..3]"));
        text.append("port in Integer[0..2] i, in Integer[0..2] j,\n");
        text.append("out %s o, out %s p, out %s q;\n".formatted(outside, outside, outside));
        List<String> sources = new ArrayList<>(List.of("i", "j"));
        List<String> senders = new ArrayList<>();
        for (int part = 0; part < count; part++) {
            text.append("component P%d p%d;\n".formatted(part, part));
            for (Sender each : outputs.get(part)) {
                senders.add("p%d.%s".formatted(part, each.name));
            }
        }
        sources.addAll(senders);
        for (int part = 0; part < count; part++) {
            for (String input : inputs.get(part)) {
                if (chance(92)) {
                    String source = part == 0 && chance(50) ? "i" : one(sources);
                    text.append("connect %s -> p%d.%s;\n".formatted(source, part, input));
                }
            }
        }
        for (String output : List.of("o", "p", "q")) {
            String source = chance(5) ? "i" : one(senders);
            text.append("connect %s -> %s;\n".formatted(source, output));
        }
        return text + "}\n";
    }
}
