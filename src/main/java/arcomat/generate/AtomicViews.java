package arcomat.generate;

import arcomat.generate.view.AssignmentView;
import arcomat.generate.view.AtomicView;
import arcomat.generate.view.CompletionView;
import arcomat.generate.view.FieldView;
import arcomat.generate.view.HeadView;
import arcomat.generate.view.SectionView;
import arcomat.generate.view.StateNameView;
import arcomat.generate.view.StateView;
import arcomat.generate.view.TransitionView;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Variable;
import arcomat.semantics.Fault;

import java.util.ArrayList;
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

    AtomicView view(HeadView head) {
        List<FieldView> constants = new ArrayList<>();
        List<FieldView> variables = new ArrayList<>();
        List<AssignmentView> constructed = new ArrayList<>();
        component.constants().forEach(v -> declare(v, constants, constructed));
        automaton.variables().forEach(v -> declare(v, variables, constructed));
        List<TransitionView> initials = automaton.initials().stream().map(this::initial).toList();
        List<SectionView> sections = states.sections();
        return new AtomicView(
                head,
                constants,
                variables,
                constructed,
                states.named() ? names() : List.of(),
                initials,
                automaton.states().size() > 1,
                sections,
                states.sectionSize(),
                completion(sections),
                context.members().state(),
                context.members().taken(),
                context.expressions().checks(),
                sections.stream().anyMatch(s -> s.states().stream().anyMatch(StateView::wide)));
    }

    boolean draws() {
        return states.draws();
    }

    private void declare(
            Variable variable, List<FieldView> fields, List<AssignmentView> constructed) {
        ExpressionText text = context.expressions();
        boolean literal = variable.initial() instanceof Expression.Constant;
        text.at(Fault.place(component, variable));
        String initial = text.inRange(variable.initial(), variable.type(), variable.name()).text();
        fields.add(
                new FieldView(
                        text.type(variable.type()),
                        context.members().of(variable),
                        literal ? initial : "",
                        variable.span() == null ? "" : Places.text(variable.span())));
        if (!literal) {
            constructed.add(new AssignmentView(text.target(variable), initial));
        }
    }

    private List<StateNameView> names() {
        List<StateNameView> names = new ArrayList<>();
        for (String state : automaton.states()) {
            String constant = context.members().state(names.size());
            names.add(new StateNameView(constant, names.size(), state));
        }
        return names;
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
