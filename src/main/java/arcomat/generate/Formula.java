package arcomat.generate;

import arcomat.generate.language.Text;
import arcomat.model.Port;
import arcomat.model.Value;

import java.util.List;
import java.util.Optional;

/** A two-valued condition in a form that can be compared and simplified. */
sealed interface Formula {
    Formula TRUE = new Truth(true);
    Formula FALSE = new Truth(false);

    record Truth(boolean value) implements Formula {}

    /** A port carries a message, or carries none. */
    record Carries(Port port, boolean something) implements Formula {}

    /**
     * The message on a port is a value, or is another one.
     *
     * @param constant the value where it is a constant
     */
    record Is(Port port, boolean equal, Optional<Value> constant, Text text, Text negated)
            implements Formula {}

    /**
     * Any other test.
     *
     * @param fact what it asks for, in the same words as tests that ask for the opposite
     * @param so whether it holds where the fact does, or where it does not
     * @param mayFail whether it may go wrong instead of saying anything
     * @param bounds what the test says about one whole number, if it says something like that
     */
    record Test(Text text, String fact, boolean so, boolean mayFail, Optional<Bounds> bounds)
            implements Formula {

        /** One that has no opposite. */
        static Test of(Text text, boolean mayFail) {
            return new Test(text, text.text(), true, mayFail, Optional.empty());
        }
    }

    record Not(Formula operand) implements Formula {}

    record And(List<Formula> operands) implements Formula {}

    record Or(List<Formula> operands) implements Formula {}

    /** A number is at least {@code low} and at most {@code high}. */
    record Bounds(String number, long low, long high) {
        boolean excludes(Bounds other) {
            return number.equals(other.number) && (high < other.low || other.high < low);
        }
    }

    /** The operands of a conjunction; what is none is one alone. */
    default List<Formula> conjuncts() {
        if (this instanceof And and) {
            return and.operands();
        }
        return equals(TRUE) ? List.of() : List.of(this);
    }
}
