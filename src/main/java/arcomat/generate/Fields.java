package arcomat.generate;

import arcomat.generate.view.AssignmentView;
import arcomat.generate.view.FieldView;
import arcomat.generate.view.StateNameView;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Variable;
import arcomat.semantics.expression.Fault;

import java.util.ArrayList;
import java.util.List;

/** Constants, variables and the names of states as a class declares them. */
final class Fields {
    private final Component component;
    private final FileContext context;
    private final List<AssignmentView> constructed = new ArrayList<>();

    /**
     * @param component of the model, for the places of errors
     * @param context of the class to be written
     */
    Fields(Component component, FileContext context) {
        this.component = component;
        this.context = context;
    }

    /** A field with its first value. */
    FieldView of(Variable variable) {
        ExpressionText text = context.expressions();
        text.at(Fault.place(component, variable));
        return new FieldView(
                text.type(variable.type()),
                context.members().of(variable),
                text.inRange(variable.initial(), variable.type(), variable.name()).text(),
                variable.span() == null ? "" : Places.text(variable.span()));
    }

    /** A field with its first value if that is a literal; else the constructor computes it. */
    FieldView declared(Variable variable) {
        FieldView field = of(variable);
        if (variable.initial() instanceof Expression.Constant) {
            return field;
        }
        String target = context.expressions().target(variable);
        constructed.add(new AssignmentView(target, field.initial()));
        return new FieldView(field.type(), field.name(), "", field.comment());
    }

    /** What the constructor computes of the fields that have been declared. */
    List<AssignmentView> constructed() {
        return constructed;
    }

    List<StateNameView> states(Automaton automaton) {
        List<StateNameView> names = new ArrayList<>();
        for (String state : automaton.states()) {
            String constant = context.members().state(names.size());
            names.add(new StateNameView(constant, names.size(), state));
        }
        return names;
    }
}
