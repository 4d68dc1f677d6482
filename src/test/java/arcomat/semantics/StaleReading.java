package arcomat.semantics;

import arcomat.model.Automaton;
import arcomat.model.Expression;
import arcomat.model.Value;
import arcomat.semantics.expression.Evaluation;
import arcomat.semantics.expression.Formulas;
import arcomat.semantics.expression.Scope;

import java.util.List;

/**
 * Evaluates a condition as generated code does: an absent port still holds an old value, and only
 * tests of presence know better.
 */
public final class StaleReading {
    private static final Scope SCOPE = new Scope(Expressions.COMPONENT, List.of());

    private final Value[] letter;
    private final Value[] fields;

    public StaleReading(Value[] letter, boolean stale) {
        this.letter = letter;
        this.fields = letter.clone();
        for (int i = 0; i < fields.length; i++) {
            if (fields[i] == null) {
                fields[i] =
                        i < 2
                                ? new Value.BooleanValue(stale)
                                : new Value.IntegerValue(stale ? 1 : 0);
            }
        }
    }

    public boolean holds(Expression condition) {
        Expression decided = condition.rewritten(this::decide);
        return Evaluation.compile(decided, SCOPE).holds(fields, new Value[0]);
    }

    /** Presence is decided by the letter, equality then by the fields. */
    private Expression decide(Expression e) {
        if (e instanceof Expression.PortMatches matches) {
            boolean present = letter[SCOPE.port(matches.port())] != null;
            if (matches.pattern() instanceof Automaton.OneOf) {
                return present ? e : Formulas.FALSE;
            }
            boolean asked = matches.pattern() instanceof Automaton.Present;
            return present == asked ? Formulas.TRUE : Formulas.FALSE;
        }
        return e;
    }
}
