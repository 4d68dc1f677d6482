package arcomat.report.verdict;

import arcomat.analysis.refinement.Answered;
import arcomat.report.page.Story.Fact;
import arcomat.report.run.RunFacts;
import arcomat.semantics.Promise;

import java.util.ArrayList;
import java.util.List;

/** What a question was, what a yes to it means, and what to do with the answer. */
final class VerdictFacts {
    private VerdictFacts() {}

    /**
     * @param limits how long was searched at most, in words; empty where nobody says
     */
    static List<Fact> of(Answered answered, String limits) {
        boolean invariant = answered.question() == Answered.Question.INVARIANT;
        List<Fact> facts = new ArrayList<>();
        facts.add(
                invariant
                        ? Fact.of(
                                "asked",
                                "whether invariant %s of %s is true in every slice of every run",
                                answered.right(),
                                answered.left())
                        : Fact.of(
                                "asked",
                                "whether %s refines %s",
                                answered.left(),
                                answered.right()));
        if (!invariant) {
            facts.add(
                    new Fact(
                            "means",
                            "whatever comes in, the left side does nothing that the right side"
                                    + " would not be allowed to do; so it can stand wherever the"
                                    + " right side stands"));
        }
        for (int side = 0; side < answered.sides().size(); side++) {
            String label = invariant ? "model" : side == 0 ? "left" : "right";
            facts.addAll(of(answered.sides().get(side), label));
        }
        if (!answered.sides().isEmpty()) {
            facts.add(RunFacts.time(answered.sides().get(0).component()));
        }
        if (!limits.isEmpty()) {
            facts.add(new Fact("limits", limits));
        }
        facts.add(new Fact("next", next(answered)));
        return facts;
    }

    private static List<Fact> of(Promise side, String label) {
        String what =
                RunFacts.completions(side.component(), side.automata())
                        .map(fact -> "; " + fact.text())
                        .orElse(", as its parts make it");
        return List.of(new Fact(label, side.title() + what));
    }

    private static String next(Answered answered) {
        return switch (answered.verdict().answer()) {
            case HOLDS ->
                    "'arcomat %s --certificate FILE' writes down why, to be verified without the search"
                            .formatted(
                                    answered.question() == Answered.Question.INVARIANT
                                            ? "verify"
                                            : "refines");
            case FAILS ->
                    answered.verdict().trace().isEmpty()
                            ? "change what the sentences below name, and ask again"
                            : "step back (Left) from the end to see what led there, change what"
                                    + " the sentences below name, and ask again";
            case UNKNOWN ->
                    "look at the reason; a longer '--timeout', more '--max-states', or a range for"
                            + " the variable that it names may help";
        };
    }
}
