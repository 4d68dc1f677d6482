package arcomat.laws.draw;

import arcomat.source.SourceFile;

import java.util.ArrayList;
import java.util.List;

/**
 * Two components with different ports, x and y, a and b, and what says how those of the first stand
 * for those of the second.
 */
public final class MapText {
    private static final List<String> TYPES = List.of("Boolean", "t.Types.E");

    private final Draw draw;

    private MapText(Draw draw) {
        this.draw = draw;
    }

    public static List<SourceFile> of(Draw draw) {
        return new MapText(draw).files();
    }

    private List<SourceFile> files() {
        boolean alike = draw.chance(60);
        String in = draw.one(TYPES);
        String out = draw.one(TYPES);
        int delay = draw.chance(50) ? 1 : 0;
        Plug x = Plug.in("x", in, draw.chance(20));
        Plug y = Plug.out("y", out, false, delay);
        Plug a = Plug.in("a", alike ? in : draw.one(TYPES), false);
        Plug b = Plug.out("b", alike ? out : draw.one(TYPES), false, draw.chance(50) ? 1 : 0);
        SourceFile left = ComponentText.atomic(draw, "m", "A", List.of(x, y), false, 1);
        SourceFile right = ComponentText.atomic(draw, "m", "B", List.of(a, b), false);
        if (alike) {
            right = renamed(left, a);
            b = Plug.out("b", out, false, delay);
        }
        List<Plug> read = new ArrayList<>(List.of(Plug.in("y", out, false)));
        if (draw.chance(25)) {
            read.add(Plug.in("x", in, false));
        }
        read.add(b.withDelay(alike || draw.chance(60) ? 0 : 1));
        return List.of(
                ComponentText.types(),
                left,
                right,
                half("Inputs", List.of(x.withTotal(false), Plug.out("a", a.type(), false, 0))),
                half("Outputs", read));
    }

    /** The same with other ports, and now and then an edit. */
    private SourceFile renamed(SourceFile left, Plug a) {
        String text =
                left.text()
                        .replace("component A", "component B")
                        .replaceAll("<<total>> in", "in")
                        .replaceAll("\\bx\\b", a.name())
                        .replaceAll("\\by\\b", "b");
        SourceFile same = new SourceFile("m/B.arc", text);
        return draw.chance(50) ? same : new Edits(draw).once(List.of(same)).get(0);
    }

    private SourceFile half(String name, List<Plug> plugs) {
        return draw.chance(75)
                ? function(name, plugs)
                : ComponentText.atomic(draw, "m", name, plugs, false);
    }

    /** What is sent depends on the first input alone; silence is silence, as a rule. */
    private SourceFile function(String name, List<Plug> plugs) {
        Plug from = plugs.get(0);
        Plug to = plugs.get(plugs.size() - 1);
        boolean same = from.type().equals(to.type()) && draw.chance(80);
        List<String> lines = new ArrayList<>(List.of("package m;", "component " + name + " {"));
        plugs.forEach(plug -> lines.add(plug.line()));
        lines.add("    <<completion = \"ignore\">> automaton {");
        lines.add("        state s;");
        lines.add("        initial s;");
        for (String message : Plug.messages(from.type())) {
            String sent = same ? message : draw.one(Plug.messages(to.type()));
            lines.add(
                    "        s {%s == %s} / {%s = %s};"
                            .formatted(from.name(), message, to.name(), sent));
        }
        if (draw.chance(15)) {
            lines.add(
                    "        s {%s == --} / {%s = %s};"
                            .formatted(from.name(), to.name(), draw.one(Plug.messages(to.type()))));
        }
        lines.add("    }");
        lines.add("}");
        return new SourceFile("m/" + name + ".arc", String.join("\n", lines) + "\n");
    }
}
