package arcomat.check.naming;

import arcomat.check.facts.StateNames;
import arcomat.check.law.Check;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.bodies.AutomatonSymbol.StateSymbol;

import java.util.List;
import java.util.Set;

/**
 * ARC0211: the states of one automaton all start in lower case or all in upper case (Wor16 AC6,
 * AC8).
 */
public final class StateNamesCapitalisedAlike implements Check.OnAutomaton {

    @Override
    public void check(AutomatonSymbol automaton, Context context, Findings findings) {
        List<StateSymbol> states = automaton.states();
        long upper = states.stream().filter(state -> startsUpper(state.name())).count();
        long lower = states.stream().filter(state -> startsLower(state.name())).count();
        if (upper == 0 || lower == 0) {
            return;
        }
        boolean upperRules = upper > lower || upper == lower && startsUpper(states.get(0).name());
        Set<String> taken = StateNames.declared(automaton);
        for (StateSymbol state : states) {
            if (upperRules ? startsLower(state.name()) : startsUpper(state.name())) {
                report(state, upperRules, automaton, taken, findings);
            }
        }
    }

    private static void report(
            StateSymbol state,
            boolean upperRules,
            AutomatonSymbol automaton,
            Set<String> taken,
            Findings findings) {
        String name = state.name();
        String better = recapitalised(name, upperRules);
        findings.report(
                state.nameSpan(),
                "state '%s' starts with %s case letter, unlike the other states; call it '%s' or"
                        + " rename the others",
                name,
                upperRules ? "a lower" : "an upper",
                better);
        if (taken.add(better)) {
            findings.fix(StateNames.rename(automaton, name, better));
        }
    }

    private static String recapitalised(String name, boolean upper) {
        char first = name.charAt(0);
        char other = upper ? Character.toUpperCase(first) : Character.toLowerCase(first);
        return other + name.substring(1);
    }

    private static boolean startsUpper(String name) {
        return Character.isUpperCase(name.charAt(0));
    }

    private static boolean startsLower(String name) {
        return Character.isLowerCase(name.charAt(0));
    }
}
