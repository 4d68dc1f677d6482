package arcomat.laws;

import arcomat.analysis.refinement.Verdict;
import arcomat.laws.draw.Draw;
import arcomat.laws.draw.Edits;
import arcomat.model.Component;
import arcomat.source.SourceFile;

import java.util.ArrayList;
import java.util.List;

/**
 * Everything refines itself, and what refines what refines a third refines that. Of an event that
 * the second one has no port for, that would ask a question that none of its inputs can ask: {@code
 * docs/semantics.md} says so.
 */
final class RefinementIsAnOrder implements Law {
    private static final String THIRD = "c.Main";

    @Override
    public String name() {
        return "2 refinement is an order";
    }

    @Override
    public List<SourceFile> draw(Draw draw) {
        List<SourceFile> files = new ArrayList<>(Pairs.draw(draw));
        List<SourceFile> right =
                files.stream().filter(file -> file.path().startsWith("b/")).toList();
        files.addAll(Pairs.edited(draw, Pairs.moved(right, "b", "c")));
        boolean atomic = right.size() == 1 && right.get(0).text().contains(" automaton");
        return atomic && draw.chance(15) ? withMoreThanTheThird(draw, files) : files;
    }

    private static List<SourceFile> withMoreThanTheThird(Draw draw, List<SourceFile> files) {
        List<SourceFile> more = new ArrayList<>(files);
        more.removeIf(file -> file.path().startsWith("a/"));
        more.removeIf(file -> file.path().startsWith("b/"));
        SourceFile right =
                files.stream().filter(file -> file.path().startsWith("b/")).findFirst().get();
        List<SourceFile> second = List.of(new Edits(draw).withMorePorts(right));
        more.addAll(second);
        more.addAll(Pairs.edited(draw, Pairs.moved(second, "b", "a")));
        return more;
    }

    @Override
    public Outcome check(Models models) {
        Component a = models.component(Pairs.LEFT);
        Component b = models.component(Pairs.RIGHT);
        Component c = models.component(THIRD);
        Verdict same = Questions.refines(a, a);
        if (Questions.fails(same)) {
            String command = Questions.command(Pairs.LEFT, Pairs.LEFT);
            return Outcome.broken("does not refine itself: " + Questions.text(same), command);
        }
        List<Component> order = List.of(a, b, c);
        for (int[] path : new int[][] {{0, 1, 2}, {2, 1, 0}, {1, 0, 2}, {1, 2, 0}}) {
            Component first = order.get(path[0]);
            Component second = order.get(path[1]);
            Component third = order.get(path[2]);
            if (!hasMoreEvents(first, second)
                    && Questions.holds(Questions.refines(first, second))
                    && Questions.holds(Questions.refines(second, third))) {
                Verdict verdict = Questions.refines(first, third);
                return Questions.fails(verdict)
                        ? broken(first, second, third, verdict)
                        : Outcome.KEPT;
            }
        }
        return Outcome.SKIPPED;
    }

    private static boolean hasMoreEvents(Component first, Component second) {
        return first.profile() == Component.Profile.EVENT_DRIVEN
                && first.inputs().stream()
                        .anyMatch(port -> !port.latched() && second.port(port.name()).isEmpty());
    }

    private static Outcome broken(
            Component first, Component second, Component third, Verdict verdict) {
        return Outcome.broken(
                "is not transitive: " + Questions.text(verdict),
                Questions.command(first.qualifiedName(), second.qualifiedName()) + ": holds",
                Questions.command(second.qualifiedName(), third.qualifiedName()) + ": holds",
                Questions.command(first.qualifiedName(), third.qualifiedName()) + ": fails");
    }
}
