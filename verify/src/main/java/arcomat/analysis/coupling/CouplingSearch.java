package arcomat.analysis.coupling;

import arcomat.analysis.search.product.Certificate.Entry;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.automaton.StepRelation.Start;
import arcomat.semantics.expression.Formulas;
import arcomat.semantics.expression.PartialEvaluation;
import arcomat.semantics.expression.Scope;
import arcomat.semantics.value.GivenUp;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * Looks for conditions that steps of both sides keep, as long as they send the same: of many
 * comparisons, those that no example contradicts (Flanagan, Leino, "Houdini, an annotation
 * assistant for ESC/Java", FME 2001), where examples come from a solver. What comes out is a
 * proposal; whether it proves anything is for {@link CouplingCheck} to say.
 */
public final class CouplingSearch {
    private static final Optional<Value> NEVER = Optional.of(new Value.BooleanValue(false));

    /**
     * So many questions are put to solvers; a second or two, where numbers are compared. Who finds
     * no conditions has waited for nothing.
     */
    private static final int MOST_QUESTIONS = 500;

    /** Assignments and gates of all questions: those about Doubles are long. */
    private static final long MOST_WORK = 5_000_000;

    /** Of both sides together; of more there are too many comparisons. */
    private static final int MOST_VARIABLES = 8;

    private final Coupling coupling;
    private final BooleanSupplier stop;
    private final List<Port> variables;
    private final Map<StatePair, List<Comparison>> found = new LinkedHashMap<>();
    private final Set<StatePair> open = new LinkedHashSet<>();
    private Optional<String> blamed = Optional.empty();
    private int questions;
    private long work;

    private CouplingSearch(Coupling coupling, BooleanSupplier stop) {
        this.coupling = coupling;
        this.stop = stop;
        this.variables = coupling.memory;
    }

    /**
     * Looks for conditions.
     *
     * @param stop asked now and then, whether to give up
     * @throws GivenUp where it takes too long
     */
    public static CouplingSearch of(Coupling coupling, BooleanSupplier stop) {
        CouplingSearch search = new CouplingSearch(coupling, stop);
        if (search.variables.size() > MOST_VARIABLES) {
            throw new GivenUp("too many variables");
        }
        search.begin();
        while (!search.open.isEmpty()) {
            StatePair pair = search.open.iterator().next();
            search.open.remove(pair);
            search.goOn(pair);
        }
        return search;
    }

    private void begin() {
        for (Start mine : coupling.left.starts()) {
            for (Start theirs : coupling.right.starts()) {
                if (coupling.isAllowed(mine, theirs)) {
                    met(Coupling.pair(mine, theirs), List.of(coupling.row(mine, theirs)));
                }
            }
        }
    }

    /** An example of variables in a pair; what it contradicts is wrong. */
    private void met(StatePair pair, List<Value> row) {
        List<Comparison> before = found.get(pair);
        List<Comparison> left =
                (before == null ? candidates(pair, row) : before)
                        .stream().filter(each -> isShown(each, row)).toList();
        found.put(pair, left);
        if (before == null || left.size() < before.size()) {
            open.add(pair);
        }
    }

    /** A check knows them as text alone: what it would not read the same is left out. */
    private List<Comparison> candidates(StatePair pair, List<Value> row) {
        List<Expression> read = new ArrayList<>(coupling.left.expressions(pair.left()));
        read.addAll(coupling.right.expressions(pair.right()));
        ComparisonText text = coupling.comparisons();
        return new PossibleComparisons(variables, PossibleComparisons.mentioned(read))
                .shownBy(row).stream()
                        .filter(each -> text.read(each.toString()).equals(Optional.of(each)))
                        .toList();
    }

    private boolean isShown(Comparison comparison, List<Value> row) {
        return comparison.claim().isTrue(variables, row.toArray(Value[]::new));
    }

    private void goOn(StatePair pair) {
        List<Slice> slices =
                coupling.messages(pair).stream()
                        .map(messages -> Slice.of(coupling, pair, messages, variables))
                        .toList();
        long least = slices.stream().mapToLong(CouplingSearch::steps).sum();
        if (questions + least > MOST_QUESTIONS) {
            throw tooMuch();
        }
        for (Slice slice : slices) {
            for (PossibleStep mine : followed(slice.mine())) {
                for (PossibleStep theirs : answers(slice, mine)) {
                    follow(slice, mine, theirs);
                }
            }
        }
    }

    /**
     * What answers a step: where some answer does always, that one alone, so that nothing has to be
     * true after others. One is preferred that leaves alike what is alike.
     */
    private List<PossibleStep> answers(Slice slice, PossibleStep mine) {
        List<PossibleStep> all = followed(slice.theirs());
        if (all.size() == 1) {
            return all;
        }
        List<PossibleStep> preferred = all.stream().sorted(coupling.likest(mine)).toList();
        List<Comparison> alike =
                Objects.requireNonNull(found.get(slice.pair())).stream()
                        .filter(coupling::isOfCounterparts)
                        .toList();
        return Stream.of(alike, List.<Comparison>of())
                .flatMap(kept -> preferred.stream().filter(each -> isSure(slice, mine, each, kept)))
                .findFirst()
                .map(List::of)
                .orElse(all);
    }

    private boolean isSure(
            Slice slice, PossibleStep mine, PossibleStep theirs, List<Comparison> kept) {
        SliceSolver solver = solver(slice, Objects.requireNonNull(found.get(slice.pair())));
        solver.claim(mine.when());
        solver.claimNot(
                solver.and(solver.answers(mine, theirs), solver.leadsTo(kept, mine, theirs)));
        return isImpossible(solver);
    }

    /** Whether that is proved. */
    private boolean isImpossible(SliceSolver solver) {
        try {
            return found(solver).isEmpty();
        } catch (GivenUp hard) {
            if (isOver()) {
                throw hard;
            }
            return false;
        }
    }

    /** At least so many questions are asked about a slice. */
    private static long steps(Slice slice) {
        return followed(slice.theirs()).isEmpty() ? 0 : followed(slice.mine()).size();
    }

    private static List<PossibleStep> followed(List<PossibleStep> steps) {
        return steps.stream()
                .filter(each -> each.target() != PossibleStep.CHAOS)
                .filter(each -> !PartialEvaluation.value(each.when()).equals(NEVER))
                .toList();
    }

    private static GivenUp tooMuch() {
        return new GivenUp("too many questions about variables");
    }

    /** Where that takes too long, only what is shown to be kept is thought of any longer. */
    private void follow(Slice slice, PossibleStep mine, PossibleStep theirs) {
        try {
            refute(slice, mine, theirs);
        } catch (GivenUp hard) {
            if (isOver() || found.get(Slice.after(mine, theirs)) == null) {
                throw hard;
            }
            blamed = blamed.or(() -> Optional.ofNullable(hard.getMessage()));
            keep(slice, mine, theirs);
        }
    }

    /** Why it is not known of some condition whether it is kept; empty where there is none. */
    public Optional<String> blamed() {
        return blamed;
    }

    private boolean isOver() {
        return isTooMuch() || stop.getAsBoolean();
    }

    private boolean isTooMuch() {
        return questions > MOST_QUESTIONS || work > MOST_WORK;
    }

    private void keep(Slice slice, PossibleStep mine, PossibleStep theirs) {
        StatePair after = Slice.after(mine, theirs);
        List<Comparison> all = Objects.requireNonNull(found.get(after));
        List<Comparison> kept =
                all.stream()
                        .filter(
                                each ->
                                        isImpossible(
                                                contradicting(List.of(each), slice, mine, theirs)))
                        .toList();
        found.put(after, kept);
        if (kept.size() < all.size()) {
            open.add(after);
        }
    }

    /** Until no example of the step contradicts what is thought of the pair after it. */
    private void refute(Slice slice, PossibleStep mine, PossibleStep theirs) {
        StatePair after = Slice.after(mine, theirs);
        Optional<Value[]> example = example(slice, mine, theirs);
        while (example.isPresent()) {
            Value[] row = example.get();
            met(after, variables.stream().map(v -> after(v, slice, mine, theirs, row)).toList());
            example = example(slice, mine, theirs);
        }
    }

    private Optional<Value[]> example(Slice slice, PossibleStep mine, PossibleStep theirs) {
        List<Comparison> known = found.get(Slice.after(mine, theirs));
        return found(contradicting(known, slice, mine, theirs));
    }

    /** Asks for an example of a step that contradicts something, or for any. */
    private SliceSolver contradicting(
            @Nullable List<Comparison> known, Slice slice, PossibleStep mine, PossibleStep theirs) {
        SliceSolver solver = solver(slice, Objects.requireNonNull(found.get(slice.pair())));
        solver.claim(mine.when());
        solver.claim(solver.answers(mine, theirs));
        if (known != null) {
            solver.claimNot(solver.leadsTo(known, mine, theirs));
        }
        return solver;
    }

    private Optional<Value[]> found(SliceSolver solver) {
        try {
            return solver.find();
        } finally {
            work += solver.work();
        }
    }

    private SliceSolver solver(Slice slice, List<Comparison> before) {
        questions++;
        if (isTooMuch()) {
            throw tooMuch();
        }
        return new SliceSolver(slice, before, coupling.observed, stop);
    }

    private static Value after(
            Port variable, Slice slice, PossibleStep mine, PossibleStep theirs, Value[] row) {
        Expression value =
                Slice.value(new Expression.PortRead(variable, variable.span()), mine, theirs);
        return Objects.requireNonNull(Scope.ofPorts(slice.ports()).value(value, row));
    }

    /** Pairs of states, each with all conditions that no example contradicts. */
    public List<Entry> proposal() {
        return entries(pair -> Objects.requireNonNull(found.get(pair)));
    }

    /**
     * The same without conditions that follow from others.
     *
     * @throws GivenUp where it takes too long
     */
    public List<Entry> shortened() {
        questions = 0;
        work = 0;
        return entries(this::needed);
    }

    private List<Entry> entries(Function<StatePair, List<Comparison>> conditions) {
        return found.keySet().stream()
                .map(
                        pair ->
                                new Entry(
                                        coupling.name(pair),
                                        conditions.apply(pair).stream()
                                                .map(Comparison::toString)
                                                .toList()))
                .toList();
    }

    private List<Comparison> needed(StatePair pair) {
        List<Comparison> all = Objects.requireNonNull(found.get(pair));
        List<Comparison> needed = new ArrayList<>(all);
        for (Comparison each :
                IntStream.range(0, all.size())
                        .mapToObj(i -> all.get(all.size() - 1 - i))
                        .toList()) {
            List<Comparison> others = needed.stream().filter(one -> one != each).toList();
            if (follows(each, others, pair)) {
                needed.remove(each);
            }
        }
        return needed;
    }

    private boolean follows(Comparison one, List<Comparison> others, StatePair pair) {
        Slice variablesOnly = new Slice(pair, List.of(), List.of(), Formulas.FALSE, variables);
        SliceSolver solver = solver(variablesOnly, others);
        solver.claimNot(solver.truth(one.claim()));
        return found(solver).isEmpty();
    }
}
