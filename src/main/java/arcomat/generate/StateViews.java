package arcomat.generate;

import arcomat.generate.view.ChunkView;
import arcomat.generate.view.ConditionView;
import arcomat.generate.view.SectionView;
import arcomat.generate.view.StateView;
import arcomat.generate.view.TransitionView;
import arcomat.model.Automaton;
import arcomat.semantics.expression.Fault;
import arcomat.semantics.expression.Guards;

import java.util.ArrayList;
import java.util.List;

/**
 * The states of an automaton with their transitions, in methods that stay small: virtual machines
 * do not compile long ones.
 */
final class StateViews {
    private static final int MOST_NAMED_STATES = 200;

    private static final int MOST_DRAWN = 63;

    private final FileContext context;
    private final Automaton automaton;
    private final Effects effects;
    private final Choosing choosing;
    private final Guards guards;
    private final Formulas formulas;
    private final Conditions conditions;
    private final Simplification simplification;
    private final List<List<Integer>> bySource = new ArrayList<>();
    private int sectionSize;

    StateViews(FileContext context, Automaton automaton, Effects effects, Choosing choosing) {
        this.context = context;
        this.automaton = automaton;
        this.effects = effects;
        this.choosing = choosing;
        this.guards = new Guards(context.component().profile());
        this.formulas = new Formulas(context.expressions());
        this.conditions = new Conditions(context);
        this.simplification = new Simplification(context.expressions()::mayBeAbsent);
        automaton.states().forEach(state -> bySource.add(new ArrayList<>()));
        for (int i = 0; i < automaton.transitions().size(); i++) {
            bySource.get(automaton.transitions().get(i).source()).add(i);
        }
    }

    boolean named() {
        return automaton.states().size() <= MOST_NAMED_STATES;
    }

    String label(int state) {
        return named() ? context.members().state(state) : String.valueOf(state);
    }

    /** Whether a transition has to be drawn anywhere. */
    boolean draws() {
        return choosing == Choosing.RANDOM
                && (automaton.initials().size() > 1
                        || sections().stream()
                                .anyMatch(s -> s.states().stream().anyMatch(StateView::chooses)));
    }

    /** Number of states per section, 0 where one section holds all. */
    int sectionSize() {
        return sectionSize;
    }

    /** Methods for parts of conditions, once the sections are known. */
    List<ConditionView> conditions() {
        return conditions.methods();
    }

    List<SectionView> sections() {
        List<StateView> states = new ArrayList<>();
        for (int state = 0; state < automaton.states().size(); state++) {
            states.add(state(state));
        }
        sectionSize = MethodSize.statesPerMethod(states);
        if (sectionSize == 0) {
            return List.of(section("", 0, states));
        }
        List<SectionView> sections = new ArrayList<>();
        for (int first = 0; first < states.size(); first += sectionSize) {
            List<StateView> some =
                    states.subList(first, Math.min(first + sectionSize, states.size()));
            int number = sections.size();
            String method = context.members().local("section", String.valueOf(number));
            sections.add(section(method, number, some));
        }
        return sections;
    }

    private static SectionView section(String method, int number, List<StateView> states) {
        List<StateView> busy =
                states.stream()
                        .filter(
                                s ->
                                        !s.transitions().isEmpty()
                                                || !s.chunks().isEmpty()
                                                || !s.error().isEmpty())
                        .toList();
        return new SectionView(method, number, busy.stream().anyMatch(StateView::chooses), busy);
    }

    private StateView state(int state) {
        List<Formula> conditions = new ArrayList<>();
        for (int index : bySource.get(state)) {
            place(index);
            conditions.add(formulas.of(guards.enabledWhen(automaton.transitions().get(index))));
        }
        boolean chooses = choosing == Choosing.RANDOM && anyOverlap(conditions);
        List<TransitionView> transitions = new ArrayList<>();
        Excluded earlier = new Excluded();
        boolean last = false;
        for (int i = 0; i < conditions.size() && !last; i++) {
            Formula shown =
                    chooses
                            ? conditions.get(i)
                            : simplification.inOpenCases(
                                    conditions.subList(0, i),
                                    simplification.after(earlier, conditions.get(i)));
            earlier.add(simplification.not(conditions.get(i)).conjuncts());
            last = !chooses && shown.equals(Formula.TRUE);
            context.expressions().where(conditions.get(i));
            transitions.add(transition(bySource.get(state).get(i), shown, last));
            context.expressions().where(Formula.TRUE);
        }
        String name = automaton.states().get(state);
        StateView whole =
                new StateView(
                        label(state),
                        name,
                        transitions,
                        chooses,
                        transitions.size() > 31,
                        last,
                        List.of(),
                        last ? "" : error(state));
        if (chooses && transitions.size() > MOST_DRAWN) {
            throw new TooManyChoices(context.component(), name, transitions.size());
        }
        return chooses || MethodSize.fits(transitions) ? whole : inChunks(whole, state);
    }

    private String error(int state) {
        boolean forbidden = automaton.completion() == Automaton.Completion.ERROR;
        String place = Fault.place(context.component(), automaton, state);
        return forbidden
                ? context.expressions().literal(place + ": the automaton forbids this input")
                : "";
    }

    private StateView inChunks(StateView state, int index) {
        List<ChunkView> chunks = new ArrayList<>();
        for (List<TransitionView> some : MethodSize.split(state.transitions())) {
            String method = context.members().local("state" + index + "part", "" + chunks.size());
            chunks.add(new ChunkView(method, some, false));
        }
        if (state.last()) {
            ChunkView end = chunks.remove(chunks.size() - 1);
            chunks.add(new ChunkView(end.method(), end.transitions(), true));
        }
        return new StateView(
                state.label(),
                state.name(),
                List.of(),
                state.chooses(),
                state.wide(),
                false,
                chunks,
                state.error());
    }

    private static boolean anyOverlap(List<Formula> conditions) {
        for (int i = 0; i < conditions.size(); i++) {
            for (int k = i + 1; k < conditions.size(); k++) {
                if (!Exclusion.contradict(conditions.get(i), conditions.get(k))) {
                    return true;
                }
            }
        }
        return false;
    }

    private void place(int index) {
        Automaton.Transition transition = automaton.transitions().get(index);
        context.expressions().at(Fault.place(context.component(), automaton, transition));
    }

    private TransitionView transition(int index, Formula condition, boolean always) {
        Automaton.Transition transition = automaton.transitions().get(index);
        place(index);
        Effects.Effect effect = effects.of(transition.sends(), transition.assignments());
        boolean stays = transition.source() == transition.target();
        return new TransitionView(
                index,
                Places.quote(transition.span()),
                always ? "" : conditions.text(index, condition),
                effect.locals(),
                effect.messages(),
                effect.assignments(),
                stays ? "" : label(transition.target()));
    }
}
