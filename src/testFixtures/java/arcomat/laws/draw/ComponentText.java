package arcomat.laws.draw;

import arcomat.source.SourceFile;

import java.util.ArrayList;
import java.util.List;

/** Arbitrary components as text: atomic ones, and compositions of others in the same package. */
public final class ComponentText {
    private static final List<String> SMALL = List.of("Boolean", "t.Types.E", "Integer[0..2]");

    private final Draw draw;
    private final String folder;
    private final boolean events;
    private final List<SourceFile> files = new ArrayList<>();

    private ComponentText(Draw draw, String folder, boolean events) {
        this.draw = draw;
        this.folder = folder;
        this.events = events;
    }

    /** The types that all random components know. */
    public static SourceFile types() {
        return new SourceFile(
                "t/Types.cd", "package t;\nclassdiagram Types {\n    enum E { k, l, m; }\n}\n");
    }

    /** One or two inputs, one or two outputs. */
    public static List<Plug> plugs(Draw draw, boolean events) {
        String type = draw.one(SMALL);
        String other = draw.chance(60) ? type : draw.one(SMALL);
        if (draw.chance(Features.UNBOUNDED, 10)) {
            type = draw.one("Integer", "String", "Double");
        }
        if (draw.chance(Features.NUMBER_TYPES, 10)) {
            type = draw.one("byte", "short", "char", "char", "Long", "float");
            other = draw.chance(50) ? type : other;
        }
        int delay = draw.chance(70) ? 1 : 0;
        List<Plug> plugs = new ArrayList<>();
        plugs.add(Plug.in("x", type, !events && draw.chance(20)));
        if (draw.chance(50)) {
            boolean latched = events && draw.chance(40);
            boolean total = !events && draw.chance(15);
            plugs.add(new Plug("w", true, other, total, 0, latched));
        }
        plugs.add(Plug.out("y", type, !events && draw.chance(15), events ? 1 : delay));
        if (draw.chance(50)) {
            int second = draw.chance(Features.MIXED_DELAYS, 40) ? 1 - delay : delay;
            plugs.add(Plug.out("z", other, !events && draw.chance(15), events ? 1 : second));
        }
        return plugs;
    }

    public static SourceFile atomic(
            Draw draw, String folder, String name, List<Plug> plugs, boolean events) {
        int count = draw.chance(Features.SEVERAL_AUTOMATA, 15) ? 2 + draw.below(2) : 1;
        return atomic(draw, folder, name, plugs, events, count);
    }

    /**
     * @param count how many automata
     */
    public static SourceFile atomic(
            Draw draw, String folder, String name, List<Plug> plugs, boolean events, int count) {
        List<String> lines = head(draw, folder, name, plugs, events);
        for (int i = 0; i < count; i++) {
            List<Plug> own = plugs;
            if (count > 1 && draw.chance(50)) {
                Plug left = draw.one(Plug.outputs(plugs));
                own = plugs.stream().filter(p -> p != left || p.total()).toList();
            }
            lines.addAll(AutomatonText.of(draw, own, events, count == 1 ? "" : "r" + i));
        }
        lines.add("}");
        return file(folder, name, lines);
    }

    /** A table, about messages that are told apart by their texts; no row goes wrong. */
    public static SourceFile table(Draw draw, String folder, String name) {
        Draw plain =
                draw.without(Features.UNBOUNDED)
                        .without(Features.NUMBER_TYPES)
                        .without(Features.ERRORS);
        List<Plug> plugs =
                plugs(plain, false).stream()
                        .map(each -> each.delay() > 0 ? each.withTotal(false) : each)
                        .toList();
        List<String> lines = head(plain, folder, name, plugs, false);
        lines.addAll(AutomatonText.table(plain, plugs));
        lines.add("}");
        return file(folder, name, lines);
    }

    /** A composition cannot promise that a part sends in every slice. */
    public static List<Plug> withoutTotalOutputs(List<Plug> plugs) {
        return plugs.stream().map(p -> p.input() ? p : p.withTotal(false)).toList();
    }

    private static List<String> head(
            Draw draw, String folder, String name, List<Plug> plugs, boolean events) {
        List<String> lines = new ArrayList<>();
        lines.add("package " + folder + ";");
        String capacity =
                events && draw.chance(50)
                        ? "<<capacity = \"%d\">> ".formatted(1 + draw.below(3))
                        : "";
        lines.add(capacity + "component " + name + " {");
        if (events) {
            lines.add("    timing untimed;");
        }
        plugs.forEach(plug -> lines.add(plug.line()));
        return lines;
    }

    private static SourceFile file(String folder, String name, List<String> lines) {
        return new SourceFile(folder + "/" + name + ".arc", String.join("\n", lines) + "\n");
    }

    /**
     * A composition of the given ports, with its parts. Its file is the last one.
     *
     * @param requirements how many automata it has besides its parts
     */
    public static List<SourceFile> composite(
            Draw draw,
            String folder,
            String name,
            List<Plug> plugs,
            boolean events,
            int requirements) {
        ComponentText text = new ComponentText(draw, folder, events);
        text.composite(name, plugs, requirements, 0);
        return text.files;
    }

    /**
     * A composition of the given ports around a component that has these ports, too: its part
     * {@code hole}. It may have a circle without a delay, and breaks a context condition then.
     *
     * @param hole the declaration of that part
     */
    public static List<SourceFile> context(
            Draw draw, String folder, String name, String hole, List<Plug> plugs, boolean events) {
        List<Plug> whole = withoutTotalOutputs(plugs);
        ComponentText text = new ComponentText(draw, folder, events);
        text.composite(name, whole, 0, 1, hole, plugs);
        return text.files;
    }

    /** What may be connected: where it leaves, and whether it does so in the slice of an input. */
    private record Source(String path, Plug plug) {}

    private record Part(String name, List<Plug> plugs) {}

    private void composite(String name, List<Plug> plugs, int requirements, int depth) {
        composite(name, plugs, requirements, depth, "", List.of());
    }

    private void composite(
            String name,
            List<Plug> plugs,
            int requirements,
            int depth,
            String hole,
            List<Plug> plugsOfHole) {
        int count = 2 + (draw.chance(30) ? draw.below(depth == 0 ? 5 : 2) : draw.below(2));
        int position = hole.isEmpty() ? -1 : draw.below(count);
        List<Part> parts = new ArrayList<>();
        List<String> lines = head(draw, folder, name, plugs, events);
        for (int i = 0; i < count; i++) {
            if (i == position) {
                parts.add(new Part("hole", plugsOfHole));
                lines.add("    " + hole);
            } else {
                String type = name + "P" + i;
                Typed part = part(type, plugs, depth);
                parts.add(new Part("p" + i, part.plugs));
                lines.add("    component %s p%d;".formatted(part.type, i));
            }
        }
        connect(plugs, parts, position >= 0 && draw.chance(30), lines);
        List<Plug> late = withoutTotalOutputs(plugs);
        for (int i = 0; i < requirements; i++) {
            lines.addAll(AutomatonText.of(draw, late, events, "r" + i));
        }
        lines.add("}");
        files.add(file(folder, name, lines));
    }

    /**
     * A component as a part.
     *
     * @param type with its arguments
     */
    private record Typed(String type, List<Plug> plugs) {}

    /** Writes a part, now and then one that has parts itself; of that, no output counts as late. */
    private Typed part(String type, List<Plug> whole, int depth) {
        List<Plug> plugs = part(whole);
        if (depth == 0 && draw.chance(12)) {
            composite(type, plugs, 0, 1);
            return new Typed(
                    type, plugs.stream().map(p -> p.input() ? p : p.withDelay(0)).toList());
        }
        if (draw.chance(Features.VARIED, 15)) {
            VariedText.Varied varied = VariedText.atomic(draw, folder, type, plugs, events, false);
            files.add(varied.file());
            return new Typed(type + "(" + VariedText.choice(draw, varied) + ")", plugs);
        }
        files.add(atomic(draw, folder, type, plugs, events));
        return new Typed(type, plugs);
    }

    /** Ports of a part: some of the types of the whole. */
    private List<Plug> part(List<Plug> whole) {
        List<String> types = whole.stream().map(Plug::type).toList();
        List<Plug> plugs = new ArrayList<>();
        plugs.add(Plug.in("i", draw.one(types), false));
        if (draw.chance(40)) {
            plugs.add(new Plug("j", true, draw.one(types), false, 0, events && draw.chance(40)));
        }
        int delay = events || draw.chance(60) ? 1 : 0;
        plugs.add(Plug.out("u", draw.one(types), false, delay));
        if (draw.chance(40)) {
            int other = !events && draw.chance(Features.MIXED_DELAYS, 50) ? 1 - delay : delay;
            plugs.add(Plug.out("v", draw.one(types), false, other));
        }
        return plugs;
    }

    private void connect(List<Plug> plugs, List<Part> parts, boolean circles, List<String> lines) {
        for (int i = 0; i < parts.size(); i++) {
            for (Plug input : Plug.inputs(parts.get(i).plugs)) {
                List<Source> possible =
                        sources(plugs, parts, circles ? parts.size() : i, input.type()).stream()
                                .filter(each -> each.plug.total() || !input.total())
                                .toList();
                if (!possible.isEmpty() && (input.total() || draw.chance(92))) {
                    String target = parts.get(i).name + "." + input.name();
                    lines.add(connection(draw.one(possible).path, target));
                }
            }
        }
        for (Plug output : Plug.outputs(plugs)) {
            List<Source> possible =
                    sources(plugs, parts, parts.size(), output.type()).stream()
                            .filter(each -> !each.plug.input() || draw.chance(15))
                            .toList();
            if (!possible.isEmpty()) {
                lines.add(connection(draw.one(possible).path, output.name()));
            }
        }
    }

    private static String connection(String source, String target) {
        return "    connect %s -> %s;".formatted(source, target);
    }

    /** Without a circle of delay 0: of the later parts only what comes late. */
    private List<Source> sources(List<Plug> plugs, List<Part> parts, int reader, String type) {
        List<Source> found = new ArrayList<>();
        for (Plug input : Plug.inputs(plugs)) {
            if (input.type().equals(type)) {
                found.add(new Source(input.name(), input));
            }
        }
        for (int i = 0; i < parts.size(); i++) {
            boolean ahead = i < reader;
            for (Plug output : Plug.outputs(parts.get(i).plugs)) {
                boolean possible = ahead || !events && output.delay() == 1;
                if (possible && output.type().equals(type)) {
                    found.add(new Source(parts.get(i).name + "." + output.name(), output));
                }
            }
        }
        return found;
    }
}
