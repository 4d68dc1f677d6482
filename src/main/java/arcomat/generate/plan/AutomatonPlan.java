package arcomat.generate.plan;

import arcomat.generate.text.Exclusion;
import arcomat.generate.text.FileContext;
import arcomat.generate.text.Formula;
import arcomat.generate.text.FormulaBuilder;
import arcomat.generate.text.RuntimeChecks;
import arcomat.generate.text.Simplification;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.semantics.expression.Fault;
import arcomat.semantics.expression.Guards;
import arcomat.semantics.expression.Presence;
import arcomat.semantics.statement.Procedure;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * What the code of an automaton decides in each state: which transitions it asks for, in which
 * order and under which conditions.
 *
 * @param states one per state of the automaton
 * @param draws whether something is drawn, at the beginning or in a state
 * @param checks whether an operation may go wrong
 */
public record AutomatonPlan(
        Automaton automaton, List<State> states, boolean draws, boolean checks) {
    private static final int MOST_DRAWN = 63;

    /**
     * A state.
     *
     * @param ways transitions that may be taken, in text order
     * @param chooses whether more than one may be enabled and one of them is to be drawn
     * @param last whether the last one is always enabled where no earlier one is
     */
    public record State(List<Way> ways, boolean chooses, boolean last) {}

    /**
     * A transition out of a state.
     *
     * @param index position in the automaton
     * @param enabled when it is enabled; of statements, what has to hold before they are looked at
     * @param asked what there is to ask once the earlier ones are not
     * @param block the statements that it is written as
     */
    public record Way(
            int index,
            Automaton.Transition transition,
            Formula enabled,
            Formula asked,
            Optional<Block> block) {
        private boolean checks() {
            if (block.isPresent()) {
                return StepChecks.areNeeded(block.get().procedure().steps());
            }
            RuntimeChecks known = RuntimeChecks.where(enabled);
            return known.areNeeded(transition.sends())
                    || known.areNeededFor(transition.assignments());
        }

        /** Whether it may come out only later that it is not enabled. */
        boolean stops() {
            return block.isPresent() && block.get().procedure().stops();
        }

        private Way asking(Formula rest) {
            return new Way(index, transition, enabled, rest, block);
        }
    }

    /**
     * Statements that are written as statements.
     *
     * @param transitions those that stand for the ways through them
     */
    public record Block(Procedure procedure, List<Automaton.Transition> transitions) {
        public Block {
            transitions = List.copyOf(transitions);
        }
    }

    /**
     * Decides.
     *
     * @throws TooManyChoices where one has to be drawn from more transitions than can be
     */
    static AutomatonPlan of(
            FileContext context, Automaton automaton, Choosing choosing, boolean traced) {
        Component component = context.component();
        boolean checks = RuntimeChecks.atBeginning(component, automaton);
        boolean random = choosing == Choosing.RANDOM;
        List<List<Way>> bySource = new ArrayList<>();
        automaton.states().forEach(state -> bySource.add(new ArrayList<>()));
        for (Blocks.Group group : new Blocks(context, automaton, random, traced).groups()) {
            Optional<Block> block =
                    group.body().map(body -> block(context, automaton, group, traced));
            Expression condition = condition(context, automaton, group, block);
            checks |= RuntimeChecks.dividesAnywhere(condition);
            Automaton.Transition transition = group.transitions().get(0);
            String place = Fault.place(component, automaton, transition);
            Formula enabled = new FormulaBuilder(context.expressions().at(place)).of(condition);
            bySource.get(transition.source())
                    .add(new Way(group.first(), transition, enabled, enabled, block));
        }
        Simplification simplification = new Simplification(context.expressions()::mayBeAbsent);
        List<State> states = new ArrayList<>();
        for (List<Way> ways : bySource) {
            State state = state(ways, random, simplification);
            if (state.chooses && ways.size() > MOST_DRAWN) {
                String name = automaton.states().get(states.size());
                throw new TooManyChoices(component, name, ways.size());
            }
            checks |= state.ways.stream().anyMatch(Way::checks);
            states.add(state);
        }
        boolean draws = automaton.initials().size() > 1 || states.stream().anyMatch(State::chooses);
        return new AutomatonPlan(automaton, states, random && draws, checks);
    }

    private static Block block(
            FileContext context, Automaton automaton, Blocks.Group group, boolean traced) {
        Automaton.Body body = group.body().orElseThrow();
        return new Block(
                Procedure.of(
                        context.component(),
                        automaton,
                        body,
                        context.isEventDriven()
                                ? Procedure.Form.AT_THE_END
                                : Procedure.Form.AT_ONCE,
                        traced && body.isNumbered()),
                group.transitions());
    }

    /** When a transition is enabled, or what has to hold before statements are looked at. */
    private static Expression condition(
            FileContext context, Automaton automaton, Blocks.Group group, Optional<Block> block) {
        Component component = context.component();
        boolean judges = context.expressions().judges();
        Guards guards =
                judges ? Guards.judging(component.profile()) : new Guards(component.profile());
        Automaton.Transition first = group.transitions().get(0);
        if (block.isEmpty() && first.isWhole()) {
            throw new OnlyStatements(component, automaton.states().get(first.source()));
        }
        if (block.isEmpty()) {
            return guards.enabledWhen(automaton, first);
        }
        Automaton.Body body = group.body().orElseThrow();
        Expression asked =
                guards.enabledWhen(
                        automaton, first.with(body.guard(), body.matches(), List.of(), List.of()));
        return new Presence(component.profile()).both(asked, block.get().procedure().entry());
    }

    private static State state(List<Way> ways, boolean random, Simplification simplification) {
        List<Formula> enabled = ways.stream().map(Way::enabled).toList();
        if (random && anyOverlap(enabled)) {
            return new State(ways, true, false);
        }
        // Of statements that may stop, nothing is known where a later transition is asked for.
        List<Formula> taken =
                ways.stream().map(way -> way.stops() ? Formula.FALSE : way.enabled).toList();
        List<Way> asked = new ArrayList<>();
        Simplification.Excluded earlier = new Simplification.Excluded();
        for (Way way : ways) {
            Formula rest = simplification.after(earlier, way.enabled);
            rest = simplification.inOpenCases(taken.subList(0, asked.size()), rest);
            asked.add(way.asking(rest));
            if (way.stops()) {
                continue;
            }
            earlier.add(simplification.not(way.enabled).conjuncts());
            if (rest.equals(Formula.TRUE)) {
                return new State(asked, false, true);
            }
        }
        return new State(asked, false, false);
    }

    /**
     * Whether two may hold together, or a later one may go wrong where an earlier one holds: who
     * draws looks at all of them.
     */
    private static boolean anyOverlap(List<Formula> conditions) {
        for (int k = 1; k < conditions.size(); k++) {
            Formula later = conditions.get(k).beforeFailing();
            for (int i = 0; i < k; i++) {
                if (!Exclusion.contradict(conditions.get(i), later)) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Whether there is an error where no transition of a state is enabled. */
    public boolean forbids(State state) {
        return automaton.completion() == Automaton.Completion.ERROR && !state.last;
    }

    /** Whether a step, or the construction, may end in an error of the model. */
    boolean mayFail() {
        return checks || states.stream().anyMatch(this::forbids);
    }

    /** Statements cannot be written as statements, and there are too many ways through them. */
    public static final class OnlyStatements extends RuntimeException {
        private static final long serialVersionUID = 1L;

        private final transient Component component;

        private OnlyStatements(Component component, String state) {
            super(
                    "state "
                            + state
                            + " has statements with too many ways through them to write each as a"
                            + " transition; a target that takes statements (entry 'statements')"
                            + " writes them as they stand, and random choices are generated where"
                            + " they are all that leads out of the state: else generate with"
                            + " --choose first");
            this.component = component;
        }

        public Component component() {
            return component;
        }
    }

    /**
     * A state has more transitions that may be enabled together than a set in one number can hold.
     */
    public static final class TooManyChoices extends RuntimeException {
        private static final long serialVersionUID = 1L;

        private final transient Component component;

        private TooManyChoices(Component component, String state, int transitions) {
            super(
                    "state "
                            + state
                            + " has "
                            + transitions
                            + " transitions that may be enabled together, and random choices are"
                            + " generated for at most "
                            + MOST_DRAWN
                            + "; make their triggers exclude each other, or generate with --choose"
                            + " first");
            this.component = component;
        }

        public Component component() {
            return component;
        }
    }
}
