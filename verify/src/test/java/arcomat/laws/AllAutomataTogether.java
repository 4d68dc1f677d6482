package arcomat.laws;

import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.laws.draw.ComponentText;
import arcomat.laws.draw.Conjunctions;
import arcomat.laws.draw.Draw;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.semantics.Promise;
import arcomat.source.SourceFile;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * A component keeps several automata if it keeps each of them, be it another component or made of
 * parts; one more automaton that writes no further port never makes that easier.
 */
final class AllAutomataTogether implements Law {
    private static final String SEVERAL = "r.Main";
    private static final String MORE = "m.Main";
    private static final String DECOMPOSED = "d.Main";

    @Override
    public String name() {
        return "3 all automata together";
    }

    @Override
    public List<SourceFile> draw(Draw draw) {
        Conjunctions conjunctions = new Conjunctions(draw);
        List<SourceFile> files = new ArrayList<>(List.of(ComponentText.types()));
        files.addAll(Pairs.edited(draw, List.of(conjunctions.one())));
        SourceFile several = conjunctions.several("r");
        files.add(several);
        files.add(conjunctions.more(several, "m"));
        files.addAll(conjunctions.decomposed("d"));
        return files;
    }

    @Override
    public Outcome check(Models models) {
        Component left = models.component(Pairs.LEFT);
        Component several = models.component(SEVERAL);
        Component decomposed = models.component(DECOMPOSED);
        Verdict verdict = Questions.refines(left, several);
        return broken(Questions.promise(left), Questions.promise(several), verdict)
                .or(() -> broken(decomposed))
                .or(() -> itself(several))
                .or(() -> more(left, models.component(MORE), verdict))
                .orElse(Outcome.KEPT);
    }

    private static Optional<Outcome> broken(Component decomposed) {
        Promise parts = Questions.promise(decomposed);
        Promise required = Promise.required(decomposed, List.of());
        return broken(parts, required, Questions.refines(parts, required));
    }

    /** What several automata allow, each of them allows. */
    private static Optional<Outcome> itself(Component several) {
        for (Automaton each : several.automata()) {
            Promise whole = Questions.promise(several);
            Promise one = whole.only(each.name()).orElseThrow();
            Verdict verdict = Questions.refines(whole, one);
            if (Questions.fails(verdict)) {
                String problem = "several automata do not refine each: " + Questions.text(verdict);
                return Optional.of(
                        Outcome.broken(problem, Questions.command(whole.title(), one.title())));
            }
        }
        return Optional.empty();
    }

    private static Optional<Outcome> broken(Promise left, Promise right, Verdict verdict) {
        Answer together = Answer.HOLDS;
        List<String> commands = new ArrayList<>();
        commands.add(command(left, right, verdict));
        for (Automaton each : right.automata()) {
            Promise one = right.only(each.name()).orElseThrow();
            Verdict own = Questions.refines(left, one);
            commands.add(command(left, one, own));
            together = together.and(own.answer());
        }
        boolean known = together != Answer.UNKNOWN && verdict.answer() != Answer.UNKNOWN;
        return known && together != verdict.answer()
                ? Optional.of(
                        Outcome.broken(
                                "all automata together say something else than each",
                                commands.toArray(new String[0])))
                : Optional.empty();
    }

    private static String command(Promise left, Promise right, Verdict verdict) {
        boolean same = left.component() == right.component();
        String command =
                same ? "verify " + right.title() : Questions.command(left.title(), right.title());
        return command + ": " + Questions.text(verdict);
    }

    private static Optional<Outcome> more(Component left, Component more, Verdict before) {
        Verdict after = Questions.refines(left, more);
        return Questions.holds(after) && Questions.fails(before)
                ? Optional.of(
                        Outcome.broken(
                                "a further automaton allows more",
                                Questions.command(Pairs.LEFT, SEVERAL) + ": fails",
                                Questions.command(Pairs.LEFT, MORE) + ": holds"))
                : Optional.empty();
    }
}
