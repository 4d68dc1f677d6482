package arcomat.analysis.coupling;

import arcomat.analysis.search.product.Certificate.Entry;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.automaton.StepRelation.Start;
import arcomat.semantics.expression.Scope;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.BooleanSupplier;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/**
 * Whether conditions prove that one automaton refines another: each beginning is among them, and
 * each step out of them is answered by one that leads to them again. Knows them as text, and
 * nothing of how they were found; each question is put to a solver of its own, whose conclusions
 * are checked.
 */
public final class CouplingCheck {
    private final Coupling coupling;
    private final BooleanSupplier stop;
    private final Conditions conditions;

    private CouplingCheck(Coupling coupling, Conditions conditions, BooleanSupplier stop) {
        this.coupling = coupling;
        this.conditions = conditions;
        this.stop = stop;
    }

    /**
     * What is wrong; empty for a proof.
     *
     * @param entries a pair of states, and conditions that are true there all together
     * @param stop asked now and then, whether to give up
     * @throws arcomat.semantics.value.GivenUp where it could not be decided
     */
    public static Optional<String> problem(
            Coupling coupling, List<Entry> entries, BooleanSupplier stop) {
        Map<StatePair, List<Comparison>> read = new LinkedHashMap<>();
        for (Entry entry : entries) {
            Optional<StatePair> pair = coupling.pair(entry.left());
            if (pair.isEmpty()) {
                return Optional.of("'%s' is no pair of states".formatted(entry.left()));
            }
            List<Comparison> all = new ArrayList<>();
            for (String text : entry.right()) {
                Optional<Comparison> one = coupling.comparisons().read(text);
                if (one.isEmpty()) {
                    return Optional.of(
                            "'%s' is no condition over variables of both sides".formatted(text));
                }
                all.add(one.get());
            }
            if (read.put(pair.get(), all) != null) {
                return Optional.of("'%s' is there twice".formatted(entry.left()));
            }
        }
        return new CouplingCheck(coupling, new Conditions(read), stop).problem();
    }

    private Optional<String> problem() {
        for (Start mine : coupling.left.starts()) {
            Optional<String> problem = atTheBeginning(mine);
            if (problem.isPresent()) {
                return problem;
            }
        }
        return conditions.byPair().keySet().stream()
                .flatMap(pair -> out(pair).stream())
                .findFirst();
    }

    /** One beginning of the right side is enough. */
    private Optional<String> atTheBeginning(Start mine) {
        String problem = "what is sent at the beginning is forbidden";
        for (Start theirs : coupling.right.starts()) {
            if (coupling.isAllowed(mine, theirs)) {
                Optional<String> missing = missing(mine, theirs);
                if (missing.isEmpty()) {
                    return missing;
                }
                problem = missing.get();
            }
        }
        return Optional.of(problem);
    }

    private Optional<String> missing(Start mine, Start theirs) {
        StatePair pair = Coupling.pair(mine, theirs);
        Optional<List<Comparison>> there = conditions.at(pair);
        if (there.isEmpty()) {
            return Optional.of(
                    "the beginning is %s, which is in no pair".formatted(coupling.name(pair)));
        }
        Value[] row = coupling.row(mine, theirs);
        return there.get().stream()
                .filter(each -> !each.claim().isTrue(coupling.memory, row))
                .findFirst()
                .map(
                        each ->
                                "at the beginning, in %s, '%s' is not true"
                                        .formatted(coupling.name(pair), each));
    }

    private Optional<String> out(StatePair pair) {
        List<Port> variables = conditions.variables();
        for (Set<String> messages : coupling.messages(pair)) {
            Slice slice = Slice.of(coupling, pair, messages, variables);
            Optional<String> problem = error(slice);
            for (int i = 0; i < slice.mine().size() && problem.isEmpty(); i++) {
                problem = unanswered(slice, slice.mine().get(i));
            }
            if (problem.isPresent()) {
                return problem;
            }
        }
        return Optional.empty();
    }

    private SliceSolver solver(Slice slice) {
        List<Comparison> before = Objects.requireNonNull(conditions.byPair().get(slice.pair()));
        return new SliceSolver(slice, before, coupling.observed, stop);
    }

    private Optional<String> error(Slice slice) {
        SliceSolver solver = solver(slice);
        solver.claim(slice.errs());
        return solver.find()
                .map(
                        row ->
                                "a run of the left side may end in an error out of "
                                        + place(slice, row));
    }

    /** Whether some step is not answered by one that leads to the conditions again. */
    private Optional<String> unanswered(Slice slice, PossibleStep mine) {
        SliceSolver solver = solver(slice);
        solver.claim(mine.when());
        for (PossibleStep theirs : slice.theirs()) {
            solver.claimNot(solver.and(solver.answers(mine, theirs), goesOn(solver, mine, theirs)));
        }
        return solver.find().map(row -> words(slice, mine, row));
    }

    /** What the left side does in chaos, only chaos allows for sure: it does not err there. */
    private int goesOn(SliceSolver solver, PossibleStep mine, PossibleStep theirs) {
        if (mine.target() == PossibleStep.CHAOS) {
            return solver.truth(theirs.target() == PossibleStep.CHAOS);
        }
        if (theirs.target() == PossibleStep.CHAOS) {
            return solver.truth(coupling.endsInChaos(theirs));
        }
        return conditions
                .at(Slice.after(mine, theirs))
                .map(after -> solver.leadsTo(after, mine, theirs))
                .orElseGet(() -> solver.truth(false));
    }

    /** Of a step that is not answered, what is wrong, by the last possible answer. */
    private String words(Slice slice, PossibleStep mine, Value[] row) {
        if (mine.target() == PossibleStep.CHAOS) {
            return "the left side may fall into chaos out of " + place(slice, row);
        }
        String problem = "is forbidden";
        for (PossibleStep theirs : slice.theirs()) {
            if (isAnswer(slice, mine, theirs, row)) {
                problem = leads(slice, mine, theirs, row);
            }
        }
        return "a step (%s) out of %s %s".formatted(mine.name(), place(slice, row), problem);
    }

    private String leads(Slice slice, PossibleStep mine, PossibleStep theirs, Value[] row) {
        if (theirs.target() == PossibleStep.CHAOS) {
            return "leads to chaos of the right side, which allows no error";
        }
        StatePair after = Slice.after(mine, theirs);
        String there = "leads to " + coupling.name(after);
        return conditions
                .at(after)
                .map(
                        all ->
                                all.stream()
                                        .filter(
                                                each ->
                                                        !Slice.after(each, mine, theirs)
                                                                .isTrue(slice.ports(), row))
                                        .findFirst()
                                        .map(each -> there + ", where '" + each + "' is not true")
                                        .orElse(there))
                .orElse(there + ", which is in no pair");
    }

    private boolean isAnswer(Slice slice, PossibleStep mine, PossibleStep theirs, Value[] row) {
        Scope scope = Scope.ofPorts(slice.ports());
        return scope.isTrue(theirs.when(), row)
                && coupling.observed.stream()
                        .allMatch(port -> allows(theirs.sent(port), mine.sent(port), scope, row));
    }

    private static boolean allows(Emitted theirs, Emitted mine, Scope scope, Value[] row) {
        return theirs.message().isPresent() && mine.message().isPresent()
                ? Objects.equals(
                        scope.value(theirs.message().get(), row),
                        scope.value(mine.message().get(), row))
                : theirs.allows(mine);
    }

    private String place(Slice slice, Value[] row) {
        String values =
                IntStream.range(0, row.length)
                        .mapToObj(i -> slice.ports().get(i).name() + " = " + row[i])
                        .collect(Collectors.joining(", "));
        return coupling.name(slice.pair()) + (values.isEmpty() ? "" : " (" + values + ")");
    }
}
