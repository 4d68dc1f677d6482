package arcomat.generate.plan;

import arcomat.generate.text.MemberNames;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;

/**
 * A tree over the nodes of a large composite: virtual machines allow a class some 250 fields and do
 * not compile methods of 8,000 bytes. A section holds consecutive nodes of the schedule, or
 * sections.
 */
public final class Sections {
    /** Where a composite holds its parts itself. */
    public static final Sections NONE = new Sections(List.of(), 0);

    private static final int MOST_MEMBERS = 100;

    /**
     * Nodes that stay together.
     *
     * @param weight size of their code
     */
    record Unit(int first, int end, int weight) {}

    /**
     * A section.
     *
     * @param path fields that lead to it from the composite, with dots
     * @param first position of the first node in the schedule
     * @param end position after the last node
     * @param inner sections in this one; none where it holds nodes itself
     */
    public record Section(String field, String path, int first, int end, List<Section> inner) {
        private Section under(String above) {
            String own = above.isEmpty() ? field : above + "." + field;
            return new Section(
                    field, own, first, end, inner.stream().map(s -> s.under(own)).toList());
        }

        private Stream<Section> all() {
            return Stream.concat(Stream.of(this), inner.stream().flatMap(Section::all));
        }
    }

    private final List<Section> top;
    private final Section[] leaves;

    private Sections(List<Section> top, int nodes) {
        this.top = top;
        this.leaves = new Section[nodes];
        all().stream()
                .filter(section -> section.inner.isEmpty())
                .forEach(leaf -> Arrays.fill(leaves, leaf.first, leaf.end, leaf));
    }

    /** Divides what stays together, where that is too much for one class. */
    static Sections of(List<Unit> units, MemberNames members) {
        List<Section> level = leaves(units, members);
        int depth = 0;
        while (level.size() > MOST_MEMBERS) {
            level = grouped(level, members, ++depth);
        }
        int nodes = units.isEmpty() ? 0 : units.get(units.size() - 1).end;
        return new Sections(level.stream().map(s -> s.under("")).toList(), nodes);
    }

    private static List<Section> leaves(List<Unit> units, MemberNames members) {
        List<Section> leaves = new ArrayList<>();
        int first = 0;
        int count = 0;
        int weight = 0;
        for (Unit unit : units) {
            boolean full = weight + unit.weight > Draft.MOST_WEIGHT || count == MOST_MEMBERS;
            if (count > 0 && full) {
                leaves.add(leaf(leaves.size(), first, unit.first, members));
                first = unit.first;
                count = 0;
                weight = 0;
            }
            count++;
            weight += unit.weight;
        }
        if (!leaves.isEmpty()) {
            leaves.add(leaf(leaves.size(), first, units.get(units.size() - 1).end, members));
        }
        return leaves;
    }

    private static Section leaf(int number, int first, int end, MemberNames members) {
        return new Section(members.local("section", number), "", first, end, List.of());
    }

    private static List<Section> grouped(List<Section> level, MemberNames members, int depth) {
        List<Section> groups = new ArrayList<>();
        for (int i = 0; i < level.size(); i += MOST_MEMBERS) {
            List<Section> inner = level.subList(i, Math.min(i + MOST_MEMBERS, level.size()));
            String name = members.local("level" + depth + "section", groups.size());
            groups.add(
                    new Section(
                            name,
                            "",
                            inner.get(0).first,
                            inner.get(inner.size() - 1).end,
                            List.copyOf(inner)));
        }
        return groups;
    }

    /** The sections that the composite itself holds; none where it holds its parts. */
    public List<Section> top() {
        return top;
    }

    /** Every section, before those inside of it. */
    public List<Section> all() {
        return top.stream().flatMap(Section::all).toList();
    }

    /** The section that holds a node; null where the composite does. */
    public @Nullable Section of(int node) {
        return node < leaves.length ? leaves[node] : null;
    }
}
