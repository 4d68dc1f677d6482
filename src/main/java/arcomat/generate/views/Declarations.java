package arcomat.generate.views;

import arcomat.generate.language.Places;
import arcomat.generate.text.ExpressionWriter;
import arcomat.generate.text.FileContext;
import arcomat.generate.view.AtomicView.StateNameView;
import arcomat.generate.view.HeadView.AssignmentView;
import arcomat.generate.view.HeadView.FieldView;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Variable;
import arcomat.semantics.expression.Fault;

import java.util.ArrayList;
import java.util.List;

/**
 * Constants, variables and the names of states as a class declares them.
 *
 * @param component of the model, for the places of errors
 * @param context of the class to be written
 */
public record Declarations(Component component, FileContext context) {

    /** A field with its first value. */
    public FieldView of(Variable variable) {
        ExpressionWriter text = context.expressions().at(Fault.place(component, variable));
        return new FieldView(
                text.type(variable.type()),
                context.members().of(variable),
                text.inRange(variable.initial(), variable.type(), variable.name()).text(),
                variable.span() == null ? "" : Places.text(variable.span()));
    }

    private static boolean isLiteral(Variable variable) {
        return variable.initial() instanceof Expression.Constant;
    }

    /**
     * Fields with their first values where those are literals; else the constructor computes them.
     */
    public List<FieldView> declared(List<Variable> variables) {
        List<FieldView> fields = new ArrayList<>();
        for (Variable variable : variables) {
            FieldView field = of(variable);
            String initial = isLiteral(variable) ? field.initial() : "";
            fields.add(new FieldView(field.type(), field.name(), initial, field.comment()));
        }
        return fields;
    }

    /** What the constructor computes. */
    public List<AssignmentView> constructed(List<Variable> variables) {
        return variables.stream()
                .filter(variable -> !isLiteral(variable))
                .map(
                        variable ->
                                new AssignmentView(
                                        context.expressions().of(variable).text(),
                                        of(variable).initial()))
                .toList();
    }

    /** The named constants of states. */
    public List<StateNameView> states(Automaton automaton) {
        List<StateNameView> names = new ArrayList<>();
        for (String state : automaton.states()) {
            String constant = context.members().state(names.size());
            names.add(new StateNameView(constant, names.size(), state));
        }
        return names;
    }
}
