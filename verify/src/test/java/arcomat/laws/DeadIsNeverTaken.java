package arcomat.laws;

import arcomat.analysis.automaton.Analyses;
import arcomat.analysis.automaton.Examination;
import arcomat.analysis.automaton.Finding;
import arcomat.laws.draw.ComponentText;
import arcomat.laws.draw.Draw;
import arcomat.laws.draw.Features;
import arcomat.model.Component;
import arcomat.model.Trace;
import arcomat.source.SourceFile;
import arcomat.source.Span;

import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** What {@code analyze} says is never taken, no run takes; what it says may go wrong, does. */
final class DeadIsNeverTaken implements Law {
    private static final String DEAD = "ARC1004";
    private static final int RUNS = 12;
    private static final int SLICES = 25;

    @Override
    public String name() {
        return "6 dead is never taken";
    }

    @Override
    public List<SourceFile> draw(Draw draw) {
        boolean events = draw.has(Features.EVENTS) && draw.chance(15);
        return List.of(
                ComponentText.types(),
                ComponentText.atomic(
                        draw, "a", "Main", ComponentText.plugs(draw, events), events, 1));
    }

    @Override
    public Outcome check(Models models) {
        Component component = models.component(Pairs.LEFT);
        Set<Span> dead = new HashSet<>();
        for (Examination each :
                Analyses.examine(Questions.promise(component), List.of(), Questions.budget())) {
            for (Finding finding : each.findings()) {
                if (finding.code().equals(DEAD)) {
                    dead.add(finding.diagnostic().span());
                }
            }
        }
        if (dead.isEmpty()) {
            return Outcome.SKIPPED;
        }
        for (int i = 0; i < RUNS; i++) {
            for (Trace.Step step :
                    RunsAreAllowed.run(component, models.seed() + i, SLICES).steps()) {
                for (Trace.Activity activity : step.activities()) {
                    if (activity.cause() instanceof Trace.Taken taken
                            && dead.contains(taken.transition().span())) {
                        return Outcome.broken(
                                "a dead transition is taken in slice " + step.number(),
                                "analyze " + Pairs.LEFT,
                                "simulate --choose random " + Pairs.LEFT);
                    }
                }
            }
        }
        return Outcome.KEPT;
    }
}
