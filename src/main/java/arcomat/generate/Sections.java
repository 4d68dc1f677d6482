package arcomat.generate;

import java.util.ArrayList;
import java.util.List;

/**
 * A tree over the nodes of a large composite: virtual machines allow a class some 250 fields and do
 * not compile methods of 8,000 bytes. A section holds consecutive nodes of the schedule, or
 * sections.
 */
final class Sections {
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
    }

    private final List<Section> top;
    private final Section[] leaves;

    Sections(List<Unit> units, Members members) {
        List<Section> level = leaves(units, members);
        int depth = 0;
        while (level.size() > MOST_MEMBERS) {
            level = grouped(level, members, ++depth);
        }
        top = level.stream().map(s -> s.under("")).toList();
        leaves = new Section[units.isEmpty() ? 0 : units.get(units.size() - 1).end];
        top.forEach(this::note);
    }

    private static List<Section> leaves(List<Unit> units, Members members) {
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

    private static Section leaf(int number, int first, int end, Members members) {
        return new Section(members.local("section", "" + number), "", first, end, List.of());
    }

    private static List<Section> grouped(List<Section> level, Members members, int depth) {
        List<Section> groups = new ArrayList<>();
        for (int i = 0; i < level.size(); i += MOST_MEMBERS) {
            List<Section> inner = level.subList(i, Math.min(i + MOST_MEMBERS, level.size()));
            String name = members.local("level" + depth + "section", "" + groups.size());
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

    private void note(Section section) {
        section.inner.forEach(this::note);
        if (section.inner.isEmpty()) {
            for (int i = section.first; i < section.end; i++) {
                leaves[i] = section;
            }
        }
    }

    /** The sections that the composite itself holds; none where it holds its parts. */
    List<Section> top() {
        return top;
    }

    /** Every section, inner ones included. */
    List<Section> all() {
        List<Section> all = new ArrayList<>();
        top.forEach(s -> addTo(all, s));
        return all;
    }

    private static void addTo(List<Section> all, Section section) {
        all.add(section);
        section.inner.forEach(s -> addTo(all, s));
    }

    /** The section that holds a node; null where the composite does. */
    public Section of(int node) {
        return node < leaves.length ? leaves[node] : null;
    }
}
