package arcomat.laws.draw;

import arcomat.source.SourceFile;

import java.util.ArrayList;
import java.util.List;

/**
 * Several automata on one component that have much in common, so that they can be kept together.
 */
public final class Conjunctions {
    private final Draw draw;
    private final boolean events;
    private final List<Plug> plugs;
    private final SourceFile sole;

    /** Nothing stands beside what is computed, or beside a table, so nothing is one. */
    public Conjunctions(Draw draw) {
        this.draw = draw;
        this.events = draw.has(Features.EVENTS) && draw.chance(15);
        this.plugs = ComponentText.plugs(draw, events);
        this.sole =
                ComponentText.atomic(
                        draw.without(Features.COMPUTED).without(Features.TABLES),
                        "a",
                        "Main",
                        plugs,
                        events,
                        1);
    }

    /** {@code a.Main} with one automaton. */
    public SourceFile one() {
        return sole;
    }

    /** A component with several automata, each a little different from that of {@code a.Main}. */
    public SourceFile several(String folder) {
        List<String> lines = new ArrayList<>(sole.text().lines().toList());
        List<String> block = new ArrayList<>(block(lines));
        lines.removeAll(block);
        lines.remove("}");
        lines.set(0, "package " + folder + ";");
        for (int i = 0, count = 2 + draw.below(2); i < count; i++) {
            lines.addAll(named(edited(block), "r" + i));
        }
        lines.add("}");
        return new SourceFile(folder + "/Main.arc", String.join("\n", lines) + "\n");
    }

    /** The same with one more automaton, made from one that is there: it writes no further port. */
    public SourceFile more(SourceFile several, String folder) {
        List<String> lines = new ArrayList<>(several.text().lines().toList());
        lines.set(0, "package " + folder + ";");
        List<String> block = named(edited(block(lines)), "more");
        lines.addAll(lines.size() - 1, block);
        return new SourceFile(folder + "/Main.arc", String.join("\n", lines) + "\n");
    }

    /** A composition with the ports of {@code a.Main} that is to keep such automata. */
    public List<SourceFile> decomposed(String folder) {
        List<Plug> late = ComponentText.withoutTotalOutputs(plugs);
        return ComponentText.composite(draw, folder, "Main", late, events, 1 + draw.below(3));
    }

    private static List<String> block(List<String> lines) {
        int start = 0;
        while (!lines.get(start).contains(" automaton")) {
            start++;
        }
        int end = start + lines.subList(start, lines.size()).indexOf("    }") + 1;
        return lines.subList(start, end);
    }

    private List<String> edited(List<String> block) {
        SourceFile file = new SourceFile("", String.join("\n", block) + "\n");
        List<SourceFile> files = List.of(file);
        Edits edits = new Edits(draw);
        for (int count = draw.below(3); count > 0; count--) {
            files = edits.once(files);
        }
        return files.get(0).text().lines().toList();
    }

    private static List<String> named(List<String> block, String name) {
        List<String> named = new ArrayList<>(block);
        named.set(0, named.get(0).replaceFirst(" automaton.*", " automaton " + name + " {"));
        return named;
    }
}
