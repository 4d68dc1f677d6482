package arcomat.laws.draw;

import arcomat.laws.naive.ByHand;
import arcomat.source.SourceFile;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/** Arbitrary components with features as text. */
public final class VariedText {
    /** Where components with features lie that are compared with what is written out by hand. */
    private static final String WITH = "with";

    private static final Plug MORE = Plug.out("q", "Boolean", false, 1);

    private final Draw draw;
    private final String folder;
    private final boolean events;
    private final List<String> features;
    private final List<String> lines = new ArrayList<>();
    private int automata;

    private VariedText(Draw draw, String folder, boolean events, List<String> features) {
        this.draw = draw;
        this.folder = folder;
        this.events = events;
        this.features = features;
    }

    /**
     * A component with features.
     *
     * @param more the condition under which it has one more output, {@code q}; {@code false} where
     *     it never does
     */
    record Varied(
            SourceFile file,
            List<Map<String, Boolean>> configurations,
            boolean parameter,
            String more) {}

    /** An atomic component with features, and one that has it as a part. */
    public static List<SourceFile> of(Draw draw, boolean events) {
        boolean alone = draw.chance(50);
        List<Plug> drawn = ComponentText.plugs(draw, events);
        List<Plug> plugs = alone ? drawn : ComponentText.withoutTotalOutputs(drawn);
        Varied varied = atomic(draw, WITH, "Main", plugs, events, !alone && draw.chance(50));
        return alone
                ? List.of(varied.file)
                : List.of(varied.file, whole(draw, varied, plugs, events), extending(draw, varied));
    }

    /**
     * @param parameter whether it has one, {@code p}
     */
    static Varied atomic(
            Draw draw,
            String folder,
            String name,
            List<Plug> plugs,
            boolean events,
            boolean parameter) {
        VariedText text =
                new VariedText(
                        draw,
                        folder,
                        events,
                        draw.one(List.of("g"), List.of("g", "h"), List.of("g", "h", "i")));
        String more = draw.chance(40) ? text.condition(1) : "false";
        text.head(name + (parameter ? "(Integer[0..2] p)" : ""));
        plugs.forEach(plug -> text.lines.add(plug.line()));
        if (!more.equals("false")) {
            text.variation(more, () -> text.lines.add(MORE.line()), () -> {});
            List<Plug> longer = Stream.concat(plugs.stream(), Stream.of(MORE)).toList();
            text.variation(
                    more,
                    () -> text.behaviour(longer, 1, parameter),
                    () -> text.behaviour(plugs, 1, parameter));
        } else {
            text.behaviour(plugs, 2, parameter);
        }
        return new Varied(text.file(name), ByHand.configurations(text.lines), parameter, more);
    }

    /** A part of its own choice in each configuration of the whole. */
    private static SourceFile whole(Draw draw, Varied varied, List<Plug> plugs, boolean events) {
        VariedText text = new VariedText(draw, WITH, events, List.of("k", "l"));
        text.head("Whole");
        plugs.forEach(plug -> text.lines.add(plug.line()));
        Map<String, String> choices = text.choices(varied);
        text.lines.add(
                "    component with.Main(%s) part;"
                        .formatted(arguments(draw, choices, varied.parameter)));
        for (Plug each : plugs) {
            String inner = "part." + each.name();
            text.lines.add(
                    "    connect %s -> %s;"
                            .formatted(
                                    each.input() ? each.name() : inner,
                                    each.input() ? inner : each.name()));
        }
        text.variation(
                substituted(varied.more, choices),
                () -> {
                    text.lines.add(MORE.line());
                    text.lines.add("    connect part.q -> q;");
                },
                () -> {});
        return text.file("Whole");
    }

    /** Another one that extends one of its configurations. */
    private static SourceFile extending(Draw draw, Varied varied) {
        String line = "component Main extends with.Main(%s) {".formatted(choice(draw, varied));
        return new SourceFile("more/Main.arc", "package more;\n" + line + "\n}\n");
    }

    /**
     * A component with features, and one that is said to refine some of its configurations, which
     * is for somebody else to prove. Timings stand there that no behaviour has.
     */
    public static List<SourceFile> refined(Draw draw) {
        List<Plug> plugs = ComponentText.plugs(draw, false);
        Varied varied = atomic(draw, WITH, "Main", plugs, false, false);
        VariedText text = new VariedText(draw, "kept", false, List.of());
        text.lines.add("package kept;");
        String refined = "with.Main(%s)".formatted(choice(draw, varied));
        String other = draw.chance(40) ? ", with.Main(%s)".formatted(choice(draw, varied)) : "";
        text.lines.add("component Main refines %s%s {".formatted(refined, other));
        text.lines.add("    timing %s;".formatted(draw.one("timed", "instant", "delayed")));
        plugs.forEach(plug -> text.lines.add(plug.line()));
        text.lines.add("    port in Boolean[3] keys, locks, out Boolean lit[2];");
        text.lines.add("    component with.Main(%s) part[2];".formatted(choice(draw, varied)));
        text.lines.add("    connect part[1].y -> lit[0];");
        return List.of(varied.file, text.file("Main"));
    }

    /** One of the allowed configurations, as arguments. */
    static String choice(Draw draw, Varied varied) {
        return arguments(draw, constant(draw.one(varied.configurations)), varied.parameter);
    }

    private static Map<String, String> constant(Map<String, Boolean> choices) {
        Map<String, String> texts = new LinkedHashMap<>();
        choices.forEach((feature, choice) -> texts.put(feature, String.valueOf(choice)));
        return texts;
    }

    /** What each feature of a part is, said with those around. */
    private Map<String, String> choices(Varied varied) {
        for (int tries = 0; tries < 10; tries++) {
            Map<String, String> choices = new LinkedHashMap<>();
            varied.configurations
                    .get(0)
                    .keySet()
                    .forEach(feature -> choices.put(feature, condition(1)));
            if (isAllowed(choices, varied)) {
                return choices;
            }
        }
        return constant(draw.one(varied.configurations));
    }

    private boolean isAllowed(Map<String, String> choices, Varied varied) {
        return ByHand.configurations(lines).stream()
                .allMatch(
                        around -> varied.configurations.contains(ByHand.choices(choices, around)));
    }

    private static String arguments(Draw draw, Map<String, String> choices, boolean parameter) {
        List<String> arguments = new ArrayList<>();
        choices.forEach((feature, condition) -> arguments.add(feature + " = " + condition));
        for (int i = arguments.size() - 1; i > 0; i--) {
            Collections.swap(arguments, i, draw.below(i + 1));
        }
        if (parameter && draw.chance(50)) {
            arguments.add(0, String.valueOf(draw.below(3)));
        } else if (parameter) {
            arguments.add(draw.below(arguments.size() + 1), "p = " + draw.below(3));
        }
        return String.join(", ", arguments);
    }

    private static String substituted(String condition, Map<String, String> choices) {
        String text = condition;
        for (Map.Entry<String, String> each : choices.entrySet()) {
            text = text.replaceAll("\\b" + each.getKey() + "\\b", each.getValue());
        }
        return text;
    }

    private void head(String name) {
        lines.add("package " + folder + ";");
        lines.add("component " + name + " {");
        if (events) {
            lines.add("    timing untimed;");
        }
        lines.add("    feature " + String.join(", ", features) + ";");
        String constraint = "    constraint (%s);".formatted(condition(2));
        if (draw.chance(50)) {
            lines.add(constraint);
        }
        if (ByHand.configurations(lines).isEmpty()) {
            lines.remove(constraint);
        }
    }

    private SourceFile file(String name) {
        lines.add("}");
        return new SourceFile(folder + "/" + name + ".arc", String.join("\n", lines) + "\n");
    }

    private void variation(String condition, Runnable then, Runnable otherwise) {
        lines.add("    varif (" + condition + ") {");
        then.run();
        int before = lines.size();
        lines.add("    } else {");
        otherwise.run();
        if (lines.size() == before + 1) {
            lines.remove(before);
        } else if (lines.get(before + 1).startsWith("    varif ")
                && isWhole(before + 1)
                && draw.chance(70)) {
            lines.remove(before);
            lines.set(before, "    } else " + lines.get(before).strip());
            return;
        }
        lines.add("    }");
    }

    /** Whether a variation is all that has been written since. */
    private boolean isWhole(int from) {
        int depth = 0;
        for (int i = from; i < lines.size() - 1; i++) {
            depth += ByHand.nesting(lines.get(i));
            if (depth == 0) {
                return false;
            }
        }
        return true;
    }

    private void behaviour(List<Plug> plugs, int depth, boolean parameter) {
        if (depth > 0 && draw.chance(70)) {
            variation(
                    condition(1),
                    () -> behaviour(plugs, depth - 1, parameter),
                    () -> behaviour(plugs, depth - 1, parameter));
        } else {
            String name = draw.chance(20) ? "r" + automata++ : "";
            AutomatonText.of(draw, plugs, events, name)
                    .forEach(line -> lines.add(parameter ? guarded(line) : line));
            if (!name.isEmpty() && draw.chance(Features.SEVERAL_AUTOMATA, 30)) {
                lines.addAll(AutomatonText.of(draw, plugs, events, "r" + automata++));
            }
        }
    }

    private String guarded(String line) {
        return line.contains("[")
                ? line
                : line.replaceFirst(
                        "-> s\\d+",
                        "$0 [p " + draw.one("<", "==", "!=") + " " + draw.below(3) + "]");
    }

    private String condition(int depth) {
        if (depth > 0 && draw.chance(40)) {
            String operator = draw.one("&&", "||", "implies", "==", "!=");
            return "(" + condition(depth - 1) + " " + operator + " " + condition(depth - 1) + ")";
        }
        return draw.chance(10) || features.isEmpty()
                ? draw.one("true", "false")
                : (draw.chance(30) ? "!" : "") + draw.one(features);
    }
}
