package arcomat.generate;

import arcomat.generate.view.AtomicView;
import arcomat.generate.view.CompletionView;
import arcomat.generate.view.FieldView;
import arcomat.generate.view.HeadView;
import arcomat.generate.view.SectionView;
import arcomat.generate.view.StateView;
import arcomat.generate.view.TransitionView;
import arcomat.model.Automaton;
import arcomat.model.Component;

import java.util.List;
import java.util.Locale;

/** The view of a time-synchronous component with an automaton. */
final class AtomicViews {
    private final Component component;
    private final Automaton automaton;
    private final FileContext context;
    private final Effects effects;
    private final StateViews states;

    AtomicViews(FileContext context, Choosing choosing) {
        this.component = context.component();
        this.automaton = Members.automaton(component).orElseThrow();
        this.context = context;
        this.effects = new Effects(component, automaton, context.members(), context.expressions());
        this.states = new StateViews(context, automaton, effects, choosing);
    }

    AtomicView view(HeadView head, boolean traced) {
        Fields fields = new Fields(component, context);
        List<FieldView> constants = component.constants().stream().map(fields::declared).toList();
        List<FieldView> variables = automaton.variables().stream().map(fields::declared).toList();
        List<TransitionView> initials = automaton.initials().stream().map(this::initial).toList();
        List<SectionView> sections = states.sections();
        return new AtomicView(
                head,
                constants,
                variables,
                fields.constructed(),
                states.named() ? fields.states(automaton) : List.of(),
                initials,
                automaton.states().size() > 1,
                sections,
                states.sectionSize(),
                states.conditions(),
                completion(sections),
                context.members().state(),
                context.members().taken(),
                traced,
                context.expressions().checks(),
                sections.stream().anyMatch(s -> s.states().stream().anyMatch(StateView::wide)));
    }

    boolean draws() {
        return states.draws();
    }

    private TransitionView initial(Automaton.Initial initial) {
        String line = initial.span() == null ? "" : " (line " + Places.line(initial.span()) + ")";
        context.expressions().at(component.name() + ", initial" + line);
        Effects.Effect effect = effects.of(initial.sends(), initial.assignments());
        return new TransitionView(
                -1,
                Places.quote(initial.span()),
                "",
                effect.locals(),
                effect.messages(),
                effect.assignments(),
                states.label(initial.state()));
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
