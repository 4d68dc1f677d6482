package lab;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.bodies.AutomatonSymbol.StateSymbol;

/** LAB0002: states have names that say something, not letters and numbers. */
final class StateSaysHowItIs implements Check.OnAutomaton {
    @Override
    public void check(AutomatonSymbol automaton, Context context, Findings findings) {
        for (StateSymbol state : automaton.states()) {
            if (state.name().matches("\\p{L}\\d*|state\\d+")) {
                findings.report(
                        state.nameSpan(),
                        "nobody knows how it is in state '%s'; give it a name that says so",
                        state.name());
            }
        }
    }
}
