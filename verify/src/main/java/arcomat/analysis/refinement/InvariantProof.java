package arcomat.analysis.refinement;

import arcomat.analysis.refinement.Verdict.Explored;
import arcomat.analysis.refinement.Verdict.Sentence;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.Moment;
import arcomat.analysis.search.packed.PairStore;
import arcomat.analysis.search.product.Counterexample;
import arcomat.analysis.search.product.TraceInclusion;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Invariant;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.model.Variable;
import arcomat.semantics.Promise;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.automaton.StepRelation;
import arcomat.semantics.invariant.InvariantWatch;
import arcomat.semantics.invariant.InvariantWatch.Truth;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;

/**
 * Whether an invariant is true in every slice of every run. The component is put beside an observer
 * that speaks where it is not; so the question is whether both together refine a component that
 * never speaks, and whose run may end in an error at any time: an error breaks no invariant.
 */
public final class InvariantProof {
    private final Promise asked;
    private final Invariant invariant;
    private final InvariantWatch watch;
    private final Budget budget;
    private final Optional<PairStore.Maker> stores;

    private InvariantProof(
            Promise asked, Invariant invariant, Budget budget, Optional<PairStore.Maker> stores) {
        this.asked = asked;
        this.invariant = invariant;
        this.watch = new InvariantWatch(asked.component(), invariant);
        this.budget = budget;
        this.stores = stores;
    }

    /**
     * @param component with the invariant; it works in slices
     * @param arguments one per parameter
     */
    public static Verdict check(
            Component component, List<Value> arguments, Invariant invariant, Budget budget) {
        return check(component, arguments, invariant, budget, Optional.empty());
    }

    /**
     * As above.
     *
     * @param stores makes places for packed pairs; empty for those in memory
     */
    public static Verdict check(
            Component component,
            List<Value> arguments,
            Invariant invariant,
            Budget budget,
            Optional<PairStore.Maker> stores) {
        Promise asked = Promise.of(component, arguments);
        InvariantProof proof = new InvariantProof(asked, invariant, budget, stores);
        return proof.verdict(inclusion -> {});
    }

    /** For whoever writes down why it holds, or reads it. */
    static InvariantProof of(Promise asked, Invariant invariant, Budget budget) {
        return new InvariantProof(asked, invariant, budget, Optional.empty());
    }

    /**
     * @param shown told the search that shows that it holds, where it does
     */
    Verdict verdict(Consumer<TraceInclusion> shown) {
        return Budget.within(
                () -> withoutSearch().orElseGet(() -> search(shown)), Verdict::unknown);
    }

    /** Where there is nothing to search for. */
    Optional<Verdict> withoutSearch() {
        return asked.obstacle(budget::insist).map(Verdict::unknown).or(this::atTheStart);
    }

    /** Before the first slice no port shows anything, but variables have values. */
    private Optional<Verdict> atTheStart() {
        if (asked.isComposition() || !watch.mentionsNoPort()) {
            return Optional.empty();
        }
        ComponentSemantics behaviour = asked.behaviour();
        for (ComponentSemantics.JointStart start : behaviour.starts(budget::insist)) {
            List<Value> values = new ArrayList<>();
            for (InvariantWatch.Seen each : watch.seen()) {
                values.add(value(behaviour, start.configurations(), each.input().name()));
            }
            Truth truth = watch.judge(asked.arguments(), values);
            if (truth != Truth.TRUE) {
                String text =
                        "Before the first slice invariant '%s' is %s"
                                .formatted(invariant.name(), InvariantCounterexample.word(truth));
                return Optional.of(
                        Verdict.breaks(
                                List.of(), List.of(sentence(text, values)), Explored.NOTHING));
            }
        }
        return Optional.empty();
    }

    private static Value value(
            ComponentSemantics behaviour, List<Configuration> configurations, String variable) {
        for (int i = 0; i < configurations.size(); i++) {
            StepRelation relation = behaviour.relations().get(i);
            List<Variable> variables = relation.automaton().variables();
            for (int slot = 0; slot < variables.size(); slot++) {
                if (variables.get(slot).name().equals(variable)) {
                    return configurations.get(i).variables().get(slot);
                }
            }
        }
        throw new IllegalArgumentException(variable + " is no variable");
    }

    private Sentence sentence(String text, List<Value> values) {
        List<String> words = new ArrayList<>();
        for (int i = 0; i < values.size(); i++) {
            words.add(watch.seen().get(i).input().name() + " = " + values.get(i));
        }
        String with = words.isEmpty() ? "" : ": " + String.join(", ", words);
        return new Sentence(text + with, Optional.of(invariant.condition().span()));
    }

    private Verdict search(Consumer<TraceInclusion> shown) {
        Promise together = side(watch.together());
        ComparedSystems systems = systems(together, budget);
        TraceInclusion inclusion = systems.inclusion(budget, () -> Optional.of(apart()), stores);
        return Budget.within(
                () -> verdict(together, systems, inclusion, shown).without(inclusion),
                reason -> Verdict.unknown(reason, explored(inclusion)));
    }

    /** The question, for a search within limits of its own. */
    ComparedSystems together(Budget limits) {
        return systems(side(watch.together()), limits);
    }

    /**
     * The same question once more, for the second engine. It writes down what a part does for all
     * that it may read; so there are many observers, and none looks at much.
     */
    ComparedSystems apart() {
        return systems(side(watch.apart()), budget);
    }

    private Promise side(Component observed) {
        return Promise.of(observed, asked.arguments());
    }

    private ComparedSystems systems(Promise observed, Budget limits) {
        return ComparedSystems.of(observed, silent(observed.component()), limits);
    }

    private Verdict verdict(
            Promise together,
            ComparedSystems systems,
            TraceInclusion inclusion,
            Consumer<TraceInclusion> shown) {
        TraceInclusion.Result result = inclusion.run();
        if (result.failure().isPresent()) {
            InvariantCounterexample told =
                    new InvariantCounterexample(asked.component(), together, watch);
            Counterexample found = inclusion.counterexample(result.failure().get());
            List<Moment> slices = told.slices(found.moments());
            List<Sentence> explanation = told.explanation(invariant, found.forbidden(), slices);
            return Verdict.breaks(slices, explanation, explored(inclusion))
                    .afterInputs(slices.size(), inclusion);
        }
        Optional<String> stopped = result.stopped().or(systems.left()::leftOut);
        if (stopped.isPresent()) {
            return Verdict.unknown(stopped.get(), explored(inclusion));
        }
        shown.accept(inclusion);
        return Verdict.holds(Optional.empty(), List.of(), explored(inclusion));
    }

    private static Explored explored(TraceInclusion inclusion) {
        return new Explored(inclusion.pairs(), inclusion.lefts(), 1);
    }

    /** Never sends what an observer sends, and may end in an error whenever it likes. */
    private Promise silent(Component observed) {
        Type one = new Type.IntegerType(Type.Width.INT, 0, 0, true);
        Variable variable = new Variable("error", one, number(0), invariant.span());
        List<Automaton.Transition> transitions =
                List.of(
                        transition(List.of()),
                        transition(List.of(new Automaton.Assignment(variable, number(1)))));
        Automaton automaton =
                new Automaton(
                        "",
                        Automaton.Completion.IGNORE,
                        Automaton.Omitted.SILENT,
                        List.of("true"),
                        List.of(variable),
                        List.of(new Automaton.Initial(0, List.of(), List.of(), invariant.span())),
                        transitions,
                        invariant.span());
        List<Port> ports =
                observed.outputs().stream()
                        .filter(each -> asked.component().port(each.name()).isEmpty())
                        .toList();
        Component c = asked.component();
        Component silent =
                new Component(
                        "",
                        invariant.name(),
                        Component.Layer.LOGIC,
                        false,
                        false,
                        c.profile(),
                        c.queueCapacity(),
                        c.cycle(),
                        List.of(),
                        List.of(),
                        ports,
                        new Component.Atomic(List.of(automaton)),
                        List.of(),
                        List.of(),
                        List.of(),
                        invariant.span());
        return Promise.of(silent, List.of());
    }

    private Expression number(long value) {
        return new Expression.Constant(
                new Value.IntegerValue(value),
                Type.IntegerType.of(Type.Width.INT),
                invariant.span());
    }

    private Automaton.Transition transition(List<Automaton.Assignment> assignments) {
        return new Automaton.Transition(
                0, 0, Optional.empty(), List.of(), List.of(), assignments, invariant.span());
    }
}
