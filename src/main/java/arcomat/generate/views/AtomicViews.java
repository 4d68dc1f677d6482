package arcomat.generate.views;

import arcomat.generate.language.Places;
import arcomat.generate.plan.AutomatonPlan;
import arcomat.generate.text.ExpressionWriter;
import arcomat.generate.text.FileContext;
import arcomat.generate.text.Formula;
import arcomat.generate.text.LineMarks;
import arcomat.generate.view.AtomicView;
import arcomat.generate.view.AtomicView.ChunkView;
import arcomat.generate.view.AtomicView.CompletionView;
import arcomat.generate.view.AtomicView.SectionView;
import arcomat.generate.view.AtomicView.StateView;
import arcomat.generate.view.AtomicView.TransitionView;
import arcomat.generate.view.HeadView;
import arcomat.generate.view.HeadView.AssignmentView;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Variable;
import arcomat.semantics.expression.Fault;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;

/**
 * The view of a component with an automaton. Its states with their transitions are in methods that
 * stay small: virtual machines do not compile long ones.
 */
public final class AtomicViews {
    private static final int MOST_NAMED_STATES = 200;

    private final FileContext context;
    private final Component component;
    private final AutomatonPlan plan;
    private final Automaton automaton;
    private final Effects effects;
    private final LongConditions conditions;
    private final boolean traced;

    /**
     * @param traced whether somebody looks at which transition was taken
     */
    public AtomicViews(FileContext context, AutomatonPlan plan, boolean traced) {
        this.context = context;
        this.traced = traced;
        this.component = context.component();
        this.plan = plan;
        this.automaton = plan.automaton();
        this.effects = new Effects(context, automaton);
        this.conditions = new LongConditions(context);
    }

    public AtomicView view(HeadView head) {
        Declarations declarations = new Declarations(component, context);
        List<Variable> computed = new ArrayList<>(component.constants());
        computed.addAll(automaton.variables());
        List<TransitionView> initials = new ArrayList<>();
        automaton.initials().forEach(each -> initials.add(initial(initials.size(), each)));
        List<StateView> states = new ArrayList<>();
        plan.states().forEach(state -> states.add(state(states.size(), state)));
        int size = MethodSize.statesPerMethod(states);
        List<SectionView> sections = sections(states, size);
        CompletionView completion = completion(sections);
        return new AtomicView(
                head,
                declarations.declared(component.constants()),
                declarations.declared(automaton.variables()),
                declarations.constructed(computed),
                hasNamedStates(automaton) ? declarations.states(automaton) : List.of(),
                initials,
                automaton.states().size() > 1,
                sections,
                size,
                conditions.methods(),
                silences(completion.reachable()),
                completion,
                context.members().state(),
                context.members().taken(),
                traced,
                plan.checks(),
                states.stream().anyMatch(StateView::wide));
    }

    /** Whether states have named constants; of very many nobody reads them. */
    public static boolean hasNamedStates(Automaton automaton) {
        return automaton.states().size() <= MOST_NAMED_STATES;
    }

    /** The named constant of a state, or its code. */
    public static String label(FileContext context, Automaton automaton, int state) {
        return hasNamedStates(automaton) ? context.members().state(state) : String.valueOf(state);
    }

    private String label(int state) {
        return label(context, automaton, state);
    }

    private TransitionView initial(int index, Automaton.Initial initial) {
        String place = component.name() + ", initial" + Fault.line(initial.span());
        Effects.Effect effect =
                effects.ofInitial(
                        context.expressions().at(place), initial.sends(), initial.assignments());
        return new TransitionView(
                -1,
                Places.quote(initial.span()),
                "",
                effect.locals(),
                effect.messages(),
                effect.assignments(),
                label(initial.state()),
                LineMarks.initial(index));
    }

    /**
     * States that share a method.
     *
     * @param size how many of them; 0 where one section holds all
     */
    private List<SectionView> sections(List<StateView> states, int size) {
        if (size == 0) {
            return List.of(section("", 0, states));
        }
        List<SectionView> sections = new ArrayList<>();
        for (int first = 0; first < states.size(); first += size) {
            int number = sections.size();
            String method = context.members().local("section", number);
            int end = Math.min(first + size, states.size());
            sections.add(section(method, number, states.subList(first, end)));
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

    private StateView state(int index, AutomatonPlan.State state) {
        List<TransitionView> transitions = new ArrayList<>();
        for (AutomatonPlan.Way way : state.ways()) {
            boolean last = state.last() && transitions.size() == state.ways().size() - 1;
            transitions.add(transition(way, last));
        }
        boolean fits = state.chooses() || MethodSize.fits(transitions);
        return new StateView(
                label(index),
                automaton.states().get(index),
                fits ? transitions : List.of(),
                state.chooses(),
                transitions.size() > 31,
                fits && state.last(),
                fits ? List.of() : chunks(index, transitions, state.last()),
                error(index, state));
    }

    private String error(int index, AutomatonPlan.State state) {
        String place = Fault.place(component, automaton, index);
        return plan.forbids(state)
                ? context.expressions().literal(place + ": the automaton forbids this input")
                : "";
    }

    private List<ChunkView> chunks(int state, List<TransitionView> transitions, boolean last) {
        List<ChunkView> chunks = new ArrayList<>();
        List<List<TransitionView>> parts = MethodSize.split(transitions);
        for (List<TransitionView> some : parts) {
            String method = context.members().local("state" + state + "part", chunks.size());
            chunks.add(new ChunkView(method, some, last && chunks.size() == parts.size() - 1));
        }
        return chunks;
    }

    private TransitionView transition(AutomatonPlan.Way way, boolean always) {
        Automaton.Transition transition = way.transition();
        boolean stays = transition.source() == transition.target();
        if (way.block().isPresent()) {
            return new TransitionView(
                    way.index(),
                    Places.quote(transition.span()),
                    way.asked().equals(Formula.TRUE)
                            ? ""
                            : conditions.text(way.index(), way.asked()),
                    List.of(),
                    List.of(),
                    List.of(),
                    stays ? "" : label(transition.target()),
                    LineMarks.transition(way.index()),
                    new StatementViews(context, automaton, effects, way, traced).view());
        }
        ExpressionWriter text =
                context.expressions()
                        .at(Fault.place(component, automaton, transition))
                        .where(way.enabled());
        Effects.Effect effect =
                effects.ofTransition(text, transition.sends(), transition.assignments());
        return new TransitionView(
                way.index(),
                Places.quote(transition.span()),
                always ? "" : conditions.text(way.index(), way.asked()),
                effect.locals(),
                effect.messages(),
                effect.assignments(),
                stays ? "" : label(transition.target()),
                LineMarks.transition(way.index()));
    }

    private List<AssignmentView> silences(boolean completes) {
        return effects.silences(
                plan.states().stream()
                        .flatMap(state -> state.ways().stream())
                        .flatMap(AtomicViews::transitions)
                        .toList(),
                completes);
    }

    private static Stream<Automaton.Transition> transitions(AutomatonPlan.Way way) {
        return way.block()
                .map(block -> block.transitions().stream())
                .orElse(Stream.of(way.transition()));
    }

    private CompletionView completion(List<SectionView> sections) {
        boolean never =
                automaton.states().size() == 1
                        && sections.size() == 1
                        && sections.get(0).states().stream().anyMatch(StateView::last);
        boolean error = automaton.completion() == Automaton.Completion.ERROR;
        return new CompletionView(
                automaton.completion().name().toLowerCase(Locale.ROOT),
                error ? List.of() : effects.completion(),
                !never && !error);
    }
}
